// Systems and calls that are odd: disks that are slow, files that cannot be locked or are another
// user's, a clock that goes back.
#include <cerrno>
#include <cstdlib>

#include <gmock/gmock.h>

#include "ensemble/seed_lock.hpp"
#include "tests/faults/mpi_job.hpp"

namespace clogflow::test {
namespace {

using testing::HasSubstr;

/// Environment variables for the programs started while it lives.
class Environment {
public:
  using Variables = std::vector<std::pair<const char*, std::string>>;
  explicit Environment(Variables variables) : variables_(std::move(variables)) {
    for (const auto& [name, value] : variables_) ::setenv(name, value.c_str(), 1);
  }
  ~Environment() {
    for (const auto& [name, value] : variables_) ::unsetenv(name);
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

private:
  Variables variables_;
};

/// A system that differs from ours in one thing.
Environment odd(const char* name, long value) {
  return Environment({{"LD_PRELOAD", CLOG_ODD_SYSTEM},
                      {"ASAN_OPTIONS", "verify_asan_link_order=0:detect_leaks=0"},
                      {name, std::to_string(value)}});
}

std::vector<std::string> words(const SmallJob& job, const std::string& out, const std::string& seeds) {
  return {"run", job.path("scene.toml"), "--flow", job.path("flow.h5"), "--out", job.path(out), "--seeds", seeds};
}

bool saved(const SmallJob& job, const std::string& out, std::uint64_t seed) {
  return std::filesystem::exists((job.path(out) / run_file_name(seed)).replace_extension(".state"));
}

// mpirun sends SIGTERM at the first Ctrl-C and kills one second later: no time to wait for a disk.
TEST(SlowDisk, CtrlCUnderMpirunSavesTheStateOfEveryRank) {
  // From an empty start: a neck that drains would end the run.
  // So long that no machine is at its end when the signal comes.
  const SmallJob job({"time.end=900 s", "output.checkpoint_interval=1 h", "inlet.start=empty"});
  const Environment slow = odd("ODD_FSYNC_MS", 3000);
  for (const int signal : {SIGINT, SIGTERM}) {
    const std::string out = fmt::format("out_{}", signal);
    MpiJob mpi({"-np", "2"}, words(job, out, "1-2"), job.path("log_" + out));
    ASSERT_TRUE(appears(job.path(out) / "run_0001.lock") && appears(job.path(out) / "run_0002.lock"));
    sleep_ms(700);
    ASSERT_FALSE(mpi.ended()) << mpi.said();
    mpi.send(signal);
    EXPECT_NE(mpi.wait(), 0);
    for (const std::uint64_t seed : {1, 2})
      EXPECT_TRUE(saved(job, out, seed)) << "signal " << signal << ", seed " << seed;
  }
}

TEST(NoLocks, WhateverTheSystemSaysTheRunGoesOnAndSaysSo) {
  const SmallJob job({"time.end=2 ms"});
  for (const int reason : {ENOLCK, EOPNOTSUPP, EINVAL, ENOSYS}) {
    const Environment without = odd("ODD_FLOCK_ERRNO", reason);
    const std::string out = fmt::format("out_{}", reason);
    for (const char* expected : {"seed 2: ", "seed 2: already done"}) {
      const Program run(words(job, out, "1-2"), job.path("log"));
      EXPECT_EQ(run.wait(), 0) << reason << run.said();
      EXPECT_THAT(run.said(), HasSubstr(expected));
    }
    const Program info({"info", job.path(out) / "run_0001.h5"}, job.path("log"));
    EXPECT_EQ(info.wait(), 0) << info.said();
    const Program flow({"info", job.path("flow.h5")}, job.path("log"));
    EXPECT_EQ(flow.wait(), 0) << flow.said();
  }
}

TEST(ClockThatGoesBack, WritesNoNegativeDuration) {
  const SmallJob job({"time.end=2 ms"});
  const Environment back = odd("ODD_CLOCK_BACK_S", 1000);
  const Program run(words(job, "out", "1-3"), job.path("log"));
  ASSERT_EQ(run.wait(), 0) << run.said();
  std::ifstream ledger(job.path("out/ensemble.csv"));
  int entries = 0;
  for (std::string line; std::getline(ledger, line);) {
    double began = 0, ended = 0;
    if (std::sscanf(line.c_str(), "%*[^,],%*[^,],%*[^,],%*[^,],%lf,%lf", &began, &ended) != 2) continue;
    ++entries;
    EXPECT_GE(ended, began) << line;
    EXPECT_LT(ended - began, 500) << line;
  }
  EXPECT_EQ(entries, 3);
}

/// What a process of the user nobody sees of the lock: "free", "held", or the refusal.
std::string seen_by_nobody(const std::filesystem::path& run_file) {
  int ends[2];
  if (::pipe(ends) != 0) return "no pipe";
  const pid_t child = fork();
  if (child == 0) {
    std::string seen = "no nobody";
    constexpr uid_t nobody = 65534;
    if (::setgid(nobody) == 0 && ::setuid(nobody) == 0) {
      try {
        seen = SeedLock::take(run_file, "call process 2 of user nobody on here") ? "free" : "held";
      } catch (const std::exception& refused) {
        seen = refused.what();
      }
    }
    [[maybe_unused]] const ssize_t written = ::write(ends[1], seen.data(), seen.size());
    ::_exit(0);
  }
  ::close(ends[1]);
  std::string seen(4096, '\0');
  const ssize_t size = ::read(ends[0], seen.data(), seen.size());
  ::close(ends[0]);
  ::waitpid(child, nullptr, 0);
  seen.resize(static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
  return seen;
}

TEST(ForeignLock, IsReadToLockItAndItsOwnerIsNamed) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can be two users";
  const ScratchFolder folder;
  std::filesystem::permissions(folder.path(), std::filesystem::perms::all);
  const auto run = folder.path() / "run_0001.h5", lock = folder.path() / "run_0001.lock";
  {
    const auto mine = SeedLock::take(run, "call process 1 of user root on here");
    ASSERT_TRUE(mine);
    ::chmod(lock.c_str(), 0644);
    EXPECT_EQ(seen_by_nobody(run), "held");
  }
  // Of a process that died.
  write_file(lock, "call process 1 of user root on here\n");
  ::chmod(lock.c_str(), 0644);
  EXPECT_EQ(seen_by_nobody(run), "free");
  write_file(lock, "call process 1 of user root on here\n");
  ::chmod(lock.c_str(), 0600);
  EXPECT_THAT(seen_by_nobody(run),
              testing::AllOf(HasSubstr("run_0001.lock (belongs to user root, whose lock cannot be tried"),
                             HasSubstr("or give another --out")));
}

// The names of calls repeat in containers, where process numbers do.
TEST(RepeatedCall, TriesAgainWhatFailedBefore) {
  const SmallJob job({"time.end=2 ms"});
  const Environment call({{"OMPI_COMM_WORLD_RANK", "0"}, {"OMPI_COMM_WORLD_SIZE", "2"}, {"PMIX_NAMESPACE", "7"}});
  write_file(job.path("out/run_0001.failed"), "7\nno room on the disk\n");
  write_file(job.path("out/ensemble.csv"),
             "call,rank,host,seed,began_unix_s,ended_unix_s,outcome,point\n7,0,here,1,1.0,2.0,"
             "failed,\"\"\n7,0,here,9,1.0,2.0,failed,\"\"\n");
  const Program again(words(job, "out", "1-2"), job.path("log"));
  EXPECT_EQ(again.wait(), 0) << again.said();
  EXPECT_THAT(again.said(), HasSubstr("seed 1: failed before (no room on the disk); is tried again"));
  EXPECT_TRUE(std::filesystem::exists(job.path("out/run_0001.h5")));
  EXPECT_FALSE(std::filesystem::exists(job.path("out/run_0001.failed")));
}

TEST(UnknownInstructionSet, IsSaidOnceBeforeAnySeed) {
  const SmallJob job;
  const Environment wrong(Environment::Variables{{"CLOG_ISA", "nonsense"}});
  const Program run(words(job, "out", "1-3"), job.path("log"));
  EXPECT_EQ(run.wait(), 1);
  EXPECT_EQ(run.said(), "clog: CLOG_ISA = nonsense (must be avx512, avx2 or x86_64)\n");
  EXPECT_FALSE(std::filesystem::exists(job.path("out")));
}

TEST(UnknownVerb, IsNamedWithTheNearest) {
  const ScratchFolder folder;
  for (const auto& [verb, answer] :
       {std::pair{"rnu", "no verb \"rnu\": is \"run\" meant?"}, std::pair{"reprot", "is \"report\" meant?"},
        std::pair{"calculate", "no verb \"calculate\": known are plan, case, walls, map, run, "}}) {
    const Program program({verb, "x"}, folder.path() / "log");
    EXPECT_EQ(program.wait(), 2);
    EXPECT_THAT(program.said(), HasSubstr(answer));
  }
}

TEST(FullSharedMemory, IsSaidByOneRankBeforeAnySeed) {
  if (geteuid() != 0 || std::system("unshare --mount true 2> /dev/null") != 0)
    GTEST_SKIP() << "needs the right to mount a small /dev/shm";
  const SmallJob job({"time.end=2 ms"});
  const std::string words = fmt::format(
      "mount -t tmpfs -o size=2M none /dev/shm && mpirun --allow-run-as-root --oversubscribe -np 2 {} run {} --flow {} "
      "--out {} --seeds 1-2",
      CLOG_PROGRAM, job.path("scene.toml").string(), job.path("flow.h5").string(), job.path("out").string());
  const std::string log = job.path("log_memory").string();
  EXPECT_NE(std::system(fmt::format("unshare --mount sh -c '{}' > {} 2>&1", words, log).c_str()), 0);
  const std::string said = text_of(log), what = "clog: /dev/shm has room for ";
  const auto first = said.find(what);
  ASSERT_NE(first, std::string::npos) << said;
  EXPECT_THAT(said, HasSubstr(" there: enlarge it, or give --no-mpi\n"));
  EXPECT_EQ(said.find(what, first + 1), std::string::npos) << said;
  EXPECT_FALSE(std::filesystem::exists(job.path("out")));
}

}  // namespace
}  // namespace clogflow::test
