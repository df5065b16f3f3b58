// Ensembles through the program, on 1, 2 and 3 ranks: the same files; finished seeds are skipped.
#include <array>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>

#include "ensemble/ensemble.hpp"
#include "tests/coupling/flow_scene.hpp"
#include "tests/dem/channel_scene.hpp"

namespace clogflow::test {
namespace {

using testing::HasSubstr;

/// Open MPI refuses root unless told, and more ranks than cores unless told. It leaves memory behind at its
/// end: where the sanitizers watch, leaks are looked for in the runs without it.
std::string mpirun(int ranks) {
  return fmt::format("ASAN_OPTIONS=detect_leaks=0 mpirun {} --oversubscribe -np {} ",
                     geteuid() == 0 ? "--allow-run-as-root" : "", ranks);
}

struct Outcome {
  int status;
  std::string text;
};

Outcome shell(const std::string& command, const std::filesystem::path& folder) {
  const std::string log = (folder / "log").string();
  const int status = std::system((command + " > " + log + " 2>&1").c_str());
  std::ostringstream text;
  text << std::ifstream(log).rdbuf();
  return {status, text.str()};
}

class EnsembleFiles : public testing::Test {
protected:
  EnsembleFiles() {
    const Scene scene = short_channel_scene(
        {"time.end=6 ms", "output.snapshot_interval=2 ms", "ensemble.seeds=1-4", "particles.diameter=50 um"});
    write_flow_grid(synthetic_flow(scene), folder_.path() / "flow.h5");
    write_file(folder_.path() / "scene.toml", effective_scene(scene));
  }

  Outcome run(const std::string& launcher, const std::string& out, const std::string& more = "") {
    return shell(launcher + CLOG_PROGRAM " run " + (folder_.path() / "scene.toml").string() + " --flow " +
                     (folder_.path() / "flow.h5").string() + " --out " + (folder_.path() / out).string() + " " + more,
                 folder_.path());
  }

  RunData read(const std::string& out, std::uint64_t seed) {
    return read_run_file(folder_.path() / out / run_file_name(seed));
  }

  ScratchFolder folder_;
};

void expect_same(const RunData& a, const RunData& b) {
  EXPECT_EQ(a.seed, b.seed);
  EXPECT_EQ(a.scene_text, b.scene_text);
  EXPECT_EQ(a.passages.time, b.passages.time);
  EXPECT_EQ(a.passages.id, b.passages.id);
  EXPECT_EQ(a.passages.y, b.passages.y);
  EXPECT_EQ(a.series.time, b.series.time);
  EXPECT_EQ(a.series.count, b.series.count);
  EXPECT_EQ(a.series.porosity, b.series.porosity);
  EXPECT_EQ(a.series.kinetic_energy, b.series.kinetic_energy);
  EXPECT_EQ(a.series.dissipated, b.series.dissipated);
  ASSERT_EQ(a.snapshots.size(), b.snapshots.size());
  for (std::size_t k = 0; k < a.snapshots.size(); ++k) {
    EXPECT_EQ(a.snapshots[k].id, b.snapshots[k].id);
    EXPECT_EQ(a.snapshots[k].position, b.snapshots[k].position);
    EXPECT_EQ(a.snapshots[k].velocity, b.snapshots[k].velocity);
    EXPECT_EQ(a.snapshots[k].torque, b.snapshots[k].torque);
  }
}

TEST_F(EnsembleFiles, AreTheSameOnAnyNumberOfRanks) {
  const Outcome alone = run("", "alone");
  ASSERT_EQ(alone.status, 0) << alone.text;
  for (const int ranks : {1, 2, 3}) {
    const std::string out = fmt::format("ranks_{}", ranks);
    const Outcome parallel = run(mpirun(ranks), out);
    ASSERT_EQ(parallel.status, 0) << parallel.text;
    for (const std::uint64_t seed : {1, 2, 3, 4}) {
      SCOPED_TRACE(fmt::format("{} ranks, seed {}", ranks, seed));
      expect_same(read("alone", seed), read(out, seed));
    }
  }
}

TEST_F(EnsembleFiles, ProcessesWithoutMpiMakeTheSame) {
  const Outcome alone = run("", "alone");
  ASSERT_EQ(alone.status, 0) << alone.text;
  const Outcome apart = run(mpirun(3), "apart", "--no-mpi");
  ASSERT_EQ(apart.status, 0) << apart.text;
  for (const std::uint64_t seed : {1, 2, 3, 4}) expect_same(read("alone", seed), read("apart", seed));
}

TEST_F(EnsembleFiles, RankZeroSaysWhatAllDid) {
  const Outcome outcome = run(mpirun(3), "out");
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  for (const int seed : {1, 2, 3, 4}) {
    const std::string line = fmt::format("seed {}: 0.006001 s simulated in ", seed);
    const auto first = outcome.text.find(line);
    ASSERT_NE(first, std::string::npos) << outcome.text;
    EXPECT_EQ(outcome.text.find(line, first + 1), std::string::npos) << outcome.text;
  }
}

TEST_F(EnsembleFiles, LaunchersThatCannotBeServedAreToldWhatToDo) {
  const Outcome recovery = run(mpirun(2) + "--enable-recovery ", "out");
  // mpirun itself then takes every end for a good one.
  EXPECT_THAT(recovery.text,
              HasSubstr("clog: mpirun --enable-recovery (wants --no-mpi: a rank that dies would leave the "
                        "others waiting)\n"));
  const Outcome srun = run("env -u PMIX_RANK SLURM_STEP_ID=0 SLURM_NTASKS=4 SLURM_PROCID=0 ", "out");
  EXPECT_NE(srun.status, 0);
  EXPECT_EQ(
      srun.text,
      "clog: srun started 4 processes and gives MPI no means to bring them together: give srun --mpi=pmix, or clog "
      "run --no-mpi\n");
  EXPECT_EQ(run("env SLURM_STEP_ID=0 SLURM_NTASKS=4 SLURM_PROCID=1 ", "out").text, "");
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "out"));
}

TEST_F(EnsembleFiles, RunsThatAreLengthenedAreHandedOutAsOthersAre) {
  ASSERT_EQ(run(mpirun(2), "out", "--set time.end='3 ms'").status, 0);
  const Outcome longer = run(mpirun(2), "out");
  ASSERT_EQ(longer.status, 0) << longer.text;
  std::ostringstream ledger;
  ledger << std::ifstream(folder_.path() / "out" / "ensemble.csv").rdbuf();
  // A header, and each seed twice.
  EXPECT_EQ(std::ranges::count(ledger.str(), '\n'), 1 + 2 * 4) << ledger.str();
  ASSERT_EQ(run("", "alone").status, 0);
  for (const std::uint64_t seed : {1, 2, 3, 4}) expect_same(read("alone", seed), read("out", seed));
}

TEST_F(EnsembleFiles, ARankThatCannotSeeTheFolderEndsTheJob) {
  const std::string words =
      fmt::format("{} run {} --flow {} --seeds 1-2 --out ", CLOG_PROGRAM, (folder_.path() / "scene.toml").string(),
                  (folder_.path() / "flow.h5").string());
  const Outcome outcome = shell(fmt::format("timeout 60 env {} {}{} : -np 1 {}/proc/none/out", mpirun(1), words,
                                            (folder_.path() / "here").string(), words),
                                folder_.path());
  EXPECT_NE(outcome.status, 0);
  EXPECT_THAT(outcome.text, HasSubstr("clog: rank 1: /proc/none/out"));
  EXPECT_THAT(outcome.text, HasSubstr("cannot be made"));
}

TEST_F(EnsembleFiles, FinishedSeedsAreSkipped) {
  ASSERT_EQ(run("", "out", "--seeds 2").status, 0);
  const auto file = folder_.path() / "out" / run_file_name(2);
  const auto written = std::filesystem::last_write_time(file);
  const Outcome again = run("", "out", "--seeds 1-3");
  EXPECT_EQ(again.status, 0) << again.text;
  EXPECT_THAT(again.text, HasSubstr("seed 2: already done"));
  EXPECT_EQ(std::filesystem::last_write_time(file), written);
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "out" / run_file_name(3)));
  // A file of another scene in the same folder is not taken for this one.
  const Outcome other = run("", "out", "--seeds 2 --set time.end='5 ms'");
  EXPECT_NE(other.status, 0);
  EXPECT_THAT(other.text, HasSubstr("run_0002.h5: is longer than what is asked for (time.end = \"6 ms\", now "
                                    "\"5 ms\"): give another --out"));
}

TEST_F(EnsembleFiles, ASweepHasAFolderForEachPointWithTheFilesOfAPlainRun) {
  const std::string sweep =
      "--seeds 1-2 --sweep 'contact.friction.rolling=0.3,0.6' --sweep 'particles.diameter = 70 um, 80 um'";
  const Outcome swept = run(mpirun(2), "sweep", sweep);
  ASSERT_EQ(swept.status, 0) << swept.text;
  EXPECT_THAT(swept.text, HasSubstr("contact.friction.rolling=0.3,particles.diameter=80um, seed 2: "));
  const Outcome plain =
      run("", "plain", "--seeds 1-2 --set contact.friction.rolling=0.3 --set particles.diameter='80 um'");
  ASSERT_EQ(plain.status, 0) << plain.text;
  for (const std::uint64_t seed : {1, 2})
    expect_same(read("plain", seed), read("sweep/contact.friction.rolling=0.3,particles.diameter=80um", seed));
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "sweep" /
                                      "contact.friction.rolling=0.6,particles.diameter=70um" / run_file_name(1)));
  // A sweep of the scene does the same; what is wrong with a point is said with its name.
  EXPECT_THAT(run("", "sweep",
                  "--seeds 1-2 --set 'ensemble.sweep=[\"contact.friction.rolling=0.3,0.6\", "
                  "\"particles.diameter=70 um,80 um\"]'")
                  .text,
              HasSubstr("particles.diameter=80um, seed 2: already done"));
  const Outcome wrong = run("", "wrong", "--sweep 'particles.diameter=80 um,80 m'");
  EXPECT_NE(wrong.status, 0);
  EXPECT_THAT(wrong.text, HasSubstr("clog: particles.diameter=80m: "));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "wrong"));
}

TEST(EnsembleJobs, TheDearestComeFirst) {
  std::vector<Ensemble> ensembles(3);
  for (std::size_t k : {0, 1, 2}) {
    ensembles[k].scene.ensemble.seeds = {1, 2};
    ensembles[k].cost = std::array{2.0, 7.0, 2.0}[k];
  }
  std::vector<std::pair<std::size_t, std::uint64_t>> order;
  for (const Job& job : jobs_of(ensembles)) order.emplace_back(job.ensemble, job.seed);
  EXPECT_THAT(order, testing::ElementsAre(testing::Pair(1, 1), testing::Pair(1, 2), testing::Pair(0, 1),
                                          testing::Pair(0, 2), testing::Pair(2, 1), testing::Pair(2, 2)));
}

TEST_F(EnsembleFiles, ASeedThatFailsIsReportedOnceAndTheRestRun) {
  // A step far too long, wanted so: every seed blows up, each with its line; the status says so.
  const Outcome broken = run(mpirun(2), "broken", "--seeds 1-2 --set time.step='20 us' --set time.allow_unstable=true");
  EXPECT_NE(broken.status, 0);
  EXPECT_THAT(broken.text, HasSubstr("2 of 2 seeds failed"));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "broken" / run_file_name(1)));
}

TEST_F(EnsembleFiles, AStepTooLongForTheSceneIsSaidOnceForAllSeeds) {
  const Outcome refused = run(mpirun(2), "refused", "--seeds 1-9 --set time.step='20 us'");
  EXPECT_NE(refused.status, 0);
  const std::string what = "is unstable: ";
  const auto first = refused.text.find(what);
  ASSERT_NE(first, std::string::npos) << refused.text;
  EXPECT_EQ(refused.text.find(what, first + 1), std::string::npos) << refused.text;
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "refused" / run_file_name(1)));
}

}  // namespace
}  // namespace clogflow::test
