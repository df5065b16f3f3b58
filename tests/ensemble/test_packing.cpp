// A finished ensemble in one file: the same statistics to the bit, and every refusal.
#include <sys/mount.h>

#include <gmock/gmock.h>

#include "coupling/base/text_file.hpp"
#include "coupling/files/run_pack.hpp"
#include "ensemble/packing.hpp"
#include "postprocess/output/statistics_files.hpp"
#include "postprocess/output/tables.hpp"
#include "tests/coupling/refusal.hpp"
#include "tests/postprocess/synthetic_ensemble.hpp"
#include "tests/scratch.hpp"

namespace clogflow {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class Packs : public testing::Test {
protected:
  std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }

  std::filesystem::path runs(std::uint64_t count) const {
    const auto made = postprocess::write_ensemble(path("runs"), {.end = 0.3, .snapshot_interval = 0.05}, count);
    write(made / "ensemble.csv",
          "call,rank,host,seed,began_unix_s,ended_unix_s,outcome,point\na,0,vm,1,1,2,done,\"\"\n");
    return made;
  }

  static void write(const std::filesystem::path& file, const std::string& text) { std::ofstream(file) << text; }

  std::string refused(const std::filesystem::path& runs) const {
    return refusal([&] { pack_ensemble({runs, path("pack.h5"), true}); });
  }

  int call(const std::string& words) const {
    return WEXITSTATUS(std::system(fmt::format("cd {} && {} > said 2>&1", path("").string(), words).c_str()));
  }
  std::string said() const { return read_text_file(path("said")); }

  ScratchFolder folder_;
};

TEST_F(Packs, HoldEveryRunToTheBit) {
  const auto made = runs(3);
  EXPECT_EQ(pack_ensemble({made, path("pack.h5"), false}), 3u);
  EXPECT_EQ(files_in(made).size(), 7u) << "three runs with their indices, and the ledger, are still there";
  const auto packed = runs_in_pack(path("pack.h5"));
  ASSERT_EQ(packed.size(), 3u);
  EXPECT_EQ(packed[1], path("pack.h5") / "run_0002.h5");
  EXPECT_EQ(run_difference(packed[1], made / "run_0002.h5"), "");
  EXPECT_EQ(run_difference(packed[1], made / "run_0001.h5"), "/passages/friction_off") << "another seed";
  EXPECT_EQ(read_run_file(packed[2]).passages.time, read_run_file(made / "run_0003.h5").passages.time);
  EXPECT_THAT(files_in(path("")), testing::Each(Not(HasSubstr(".part"))));
}

TEST_F(Packs, GiveTheSameStatisticsForAnyNumberOfReaders) {
  const auto made = runs(40);
  pack_ensemble({made, path("pack.h5"), false});
  // Padding may differ between equal records: their tables and steady states do not.
  const auto records = [&](const std::filesystem::path& from, std::size_t readers) {
    const auto groups = postprocess::gather({from}, {}, readers);
    std::string text;
    for (const auto& [file, table] : postprocess::tables_of(groups)) text += table;
    for (const auto& record : groups.at(0).records)
      text += fmt::format("{} {} {} {}\n", record.seed, record.file.filename().string(), record.steady.packing_fraction,
                          record.window.end);
    return text;
  };
  const std::string alone = records(made, 1);
  for (const std::size_t readers : {2, 3, 41}) EXPECT_TRUE(records(made, readers) == alone) << readers;
  EXPECT_TRUE(records(path("pack.h5"), 2) == alone);
  for (const char* name : {"runs", "pack.h5"})
    postprocess::write_statistics(
        {{path(name)}, path(std::string("of ") + name), {}, {.p_value_replicates = 0, .resampling = {}}});
  std::string of_pack = read_text_file(path("of pack.h5/stats.json"));
  for (std::size_t at; (at = of_pack.find("pack.h5/")) != std::string::npos;) of_pack.replace(at, 7, "runs");
  EXPECT_TRUE(of_pack == read_text_file(path("of runs/stats.json"))) << "but for where the files are";
}

TEST_F(Packs, RemoveWhatTheyHoldWhenAsked) {
  const auto made = runs(2);
  pack_ensemble({made, path("pack.h5"), true});
  EXPECT_FALSE(std::filesystem::exists(made));
  EXPECT_EQ(read_run_file(path("pack.h5/run_0001.h5")).seed, 1u);
  runs(2);
  write(made / "notes.txt", "mine");
  pack_ensemble({made, path("again.h5"), true});
  EXPECT_EQ(files_in(made), std::vector<std::string>{"notes.txt"});
}

TEST_F(Packs, RefuseWhatIsNotFinished) {
  const auto made = runs(2);
  for (const char* name :
       {"run_0003.state", "run_0003.failed", "ahead_0003.h5", "shorter_0001.h5", "run_0003.h5.clog.part"}) {
    write(made / name, "");
    EXPECT_THAT(refused(made), AllOf(StartsWith(made.string() + ": is not finished (" + name),
                                     HasSubstr("let the same clog run end")));
    std::filesystem::remove(made / name);
  }
  write(made / "ensemble.csv",
        "call,rank,host,seed,began_unix_s,ended_unix_s,outcome,point\na,0,vm,7,1,2,stopped,\"\"\n");
  EXPECT_THAT(refused(made), HasSubstr("is not finished (ensemble.csv: seed 7 stopped)"));
  EXPECT_EQ(refused(path("none")), path("none").string() + ": no such folder");
  std::filesystem::create_directories(path("sweep/particles.diameter=1um"));
  EXPECT_THAT(refused(path("sweep")), HasSubstr("of a sweep each of its folders is packed by itself"));
  EXPECT_FALSE(std::filesystem::exists(path("pack.h5")));
  EXPECT_TRUE(std::filesystem::exists(made / "run_0002.h5"));
}

TEST_F(Packs, RefuseADamagedRunAndRemoveNothing) {
  const auto made = runs(2);
  std::filesystem::resize_file(made / "run_0002.h5", std::filesystem::file_size(made / "run_0002.h5") / 2);
  EXPECT_THAT(refused(made), AllOf(HasSubstr("run_0002.h5"), HasSubstr("cut off")));
  EXPECT_TRUE(std::filesystem::exists(made / "run_0001.h5"));
  EXPECT_FALSE(std::filesystem::exists(path("pack.h5")));
}

TEST_F(Packs, AreRefusedWhenTheyAreCutOffMissingOrThere) {
  const auto made = runs(2);
  pack_ensemble({made, path("pack.h5"), false});
  EXPECT_THAT(refused(made), HasSubstr("pack.h5: is there already"));
  EXPECT_THAT(refusal([&] { read_run_file(path("pack.h5/run_0009.h5")); }),
              HasSubstr("pack.h5/run_0009.h5 (no such run in this pack)"));
  std::filesystem::resize_file(path("pack.h5"), std::filesystem::file_size(path("pack.h5")) - 1000);
  EXPECT_THAT(refusal([&] { postprocess::gather({path("pack.h5")}, {}); }),
              AllOf(HasSubstr("pack.h5"), HasSubstr("cut off")));
  EXPECT_THAT(refusal([&] { postprocess::gather({path("gone.h5")}, {}); }), HasSubstr("no such folder, and no pack"));
  EXPECT_THAT(refusal([&] { postprocess::gather({made / "run_0001.h5"}, {}); }),
              HasSubstr("is a \"clogflow run\" file, a \"clogflow pack\" file is needed"));
}

TEST_F(Packs, LeaveNothingOnAFullDisk) {
  const auto made = runs(6);
  std::filesystem::create_directories(path("full"));
  if (::mount("none", path("full").c_str(), "tmpfs", 0, "size=64k") != 0)
    GTEST_SKIP() << "needs the right to mount a small disk";
  const std::string said = refusal([&] { pack_ensemble({made, path("full/pack.h5"), true}); });
  const auto left = files_in(path("full"));
  ::umount(path("full").c_str());
  EXPECT_THAT(said, AllOf(HasSubstr("pack.h5"), testing::AnyOf(HasSubstr("No space left"), HasSubstr("disk full?"))));
  EXPECT_TRUE(left.empty());
  EXPECT_TRUE(std::filesystem::exists(made / "run_0006.h5"));
}

TEST_F(Packs, ByTheProgram) {
  runs(2);
  const std::string clog = CLOG_PROGRAM;
  EXPECT_EQ(call("ulimit -f 16; exec " + clog + " pack runs --out small.h5 --remove"), 1);
  EXPECT_THAT(said(), AllOf(StartsWith("clog: small.h5"), HasSubstr("File too large")));
  EXPECT_EQ(std::ranges::count(said(), '\n'), 1);
  EXPECT_EQ(call(clog + " pack runs --out pack.h5 --remove"), 0) << said();
  EXPECT_THAT(said(), HasSubstr("pack.h5: 2 runs, each compared with its file; the files are removed"));
  EXPECT_FALSE(std::filesystem::exists(path("runs")));
  EXPECT_EQ(call(clog + " info pack.h5"), 0);
  EXPECT_THAT(said(), HasSubstr("pack.h5: a pack of 2 run files, run_0001.h5 to run_0002.h5"));
  EXPECT_EQ(call(clog + " info pack.h5/run_0002.h5"), 0);
  EXPECT_THAT(said(), HasSubstr("a run file: what the particles of seed 2 did"));
  EXPECT_EQ(call(clog + " stats pack.h5 --out stats --p-value 0"), 0) << said();
  write(path("scene.toml"),
        "[particles]\ndiameter = \"1 mm\"\ndensity = \"1000 kg/m3\"\n[contact]\nyoungs_modulus = \"1 "
        "MPa\"\npoisson_ratio = 0.3\n"
        "[box]\nmin = [\"0 m\", \"0 m\", \"0 m\"]\nmax = [\"1 cm\", \"1 cm\", \"1 cm\"]\n[time]\nend = \"1 ms\"\nstep "
        "= \"1 us\"\n");
  EXPECT_EQ(call(clog + " run scene.toml --seeds 1 --out pack.h5"), 1);
  EXPECT_THAT(said(), HasSubstr("pack.h5: is a file: runs go into a folder, and none is added to a pack"));
}

}  // namespace
}  // namespace clogflow
