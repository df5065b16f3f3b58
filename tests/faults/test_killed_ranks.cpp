// Ranks of an ensemble killed at random: nothing is lost, and the bits are the same. With MPI the job ends and the next
// call does the rest; without it the others go on.
#include <gmock/gmock.h>

#include "tests/faults/mpi_job.hpp"

namespace clogflow::test {
namespace {

using testing::HasSubstr;

constexpr int seeds = 6;

class KilledRanks : public testing::Test {
protected:
  KilledRanks() {
    const auto before = std::chrono::steady_clock::now();
    undisturbed_ = job_.complete("undisturbed", fmt::format("1-{}", seeds));
    whole_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - before).count();
  }

  MpiJob start(const std::string& out, const std::vector<std::string>& options,
               const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"run",   job_.path("scene.toml"), "--flow",  job_.path("flow.h5"),
                                   "--out", job_.path(out),          "--seeds", fmt::format("1-{}", seeds)};
    words.insert(words.end(), more.begin(), more.end());
    return {options, words, job_.path("log_" + out)};
  }

  /// Kills a rank after a while, from the start of the program to where all seeds are nearly done. A machine
  /// that is slower today has its longer while. \return whether there was one
  bool kill_one(MpiJob& mpi) {
    for (sleep_ms(static_cast<int>(random_() % static_cast<unsigned>(0.4 * whole_))); !mpi.ended(); sleep_ms(1)) {
      const std::vector<pid_t> ranks = mpi.ranks();
      if (ranks.empty()) continue;
      ::kill(ranks[random_() % ranks.size()], SIGKILL);
      return true;
    }
    return false;
  }

  int done(const std::string& out) const {
    int count = 0;
    for (int seed = 1; seed <= seeds; ++seed) count += std::filesystem::exists(job_.path(out) / run_file_name(seed));
    return count;
  }

  void expect_undisturbed(const std::string& out) const {
    for (int seed = 1; seed <= seeds; ++seed) {
      SCOPED_TRACE(fmt::format("{}, seed {}", out, seed));
      ASSERT_TRUE(std::filesystem::exists(job_.path(out) / run_file_name(seed))) << text_of(job_.path("log_" + out));
      EXPECT_TRUE(job_.result(out, seed) == job_.result("undisturbed", seed));
    }
    for (const auto& entry : std::filesystem::directory_iterator(job_.path(out)))
      EXPECT_THAT(entry.path().extension().string(), testing::AnyOf(".h5", ".xmf", ".csv"));
  }

  SmallJob job_;
  std::string undisturbed_;
  double whole_ = 0;  // of all seeds by one process [ms]
  std::mt19937 random_{2026};
};

TEST_F(KilledRanks, WithoutMpiTwoOfThreeAndTheThirdDoesTheRest) {
  ASSERT_EQ(undisturbed_, "");
  const int wanted = kills(8);
  int killed = 0, early = 0;
  for (int call = 0; killed < wanted && call < 60; ++call) {
    const std::string out = fmt::format("out_{}", call);
    MpiJob mpi = start(out, {"--enable-recovery", "-np", "3"}, {"--no-mpi"});
    const int before = killed;
    killed += kill_one(mpi);
    early += done(out) < seeds;
    if (!mpi.ended()) killed += kill_one(mpi);
    EXPECT_EQ(mpi.wait(), 0) << mpi.said();
    if (killed > before) expect_undisturbed(out);
  }
  EXPECT_GE(killed, wanted);
  EXPECT_GE(early, 2) << "the kills came when all was done";
}

TEST_F(KilledRanks, WithMpiTheNextCallDoesTheRest) {
  ASSERT_EQ(undisturbed_, "");
  const int wanted = kills(8);
  int killed = 0, early = 0;
  for (int call = 0; killed < wanted && call < 60; ++call) {
    const std::string out = fmt::format("mpi_{}", killed / 4);
    MpiJob mpi = start(out, {"-np", "3"});
    const int before = killed;
    killed += kill_one(mpi);
    mpi.wait();
    early += killed > before && done(out) < seeds;
    // Four kills, then a call that is left in peace.
    if (killed % 4 || killed == before) continue;
    MpiJob last = start(out, {"-np", "2"});
    EXPECT_EQ(last.wait(), 0) << last.said();
    expect_undisturbed(out);
  }
  EXPECT_GE(killed, wanted);
  EXPECT_GE(early, 2) << "the kills came when all was done";
}

TEST_F(KilledRanks, EfficiencyIsSaidAndEverySeedIsInTheLedger) {
  ASSERT_EQ(undisturbed_, "");
  MpiJob mpi = start("whole", {"-np", "2"});
  ASSERT_EQ(mpi.wait(), 0) << mpi.said();
  EXPECT_THAT(mpi.said(), testing::ContainsRegex("2 ranks, busy [0-9.]+ % of [0-9.]+ s"));
  const std::string ledger = text_of(job_.path("whole/ensemble.csv"));
  EXPECT_THAT(ledger, testing::StartsWith("call,rank,host,seed,began_unix_s,ended_unix_s,outcome,point\n"));
  EXPECT_EQ(std::ranges::count(ledger, '\n'), seeds + 1) << ledger;
  for (int seed = 1; seed <= seeds; ++seed) EXPECT_THAT(ledger, HasSubstr(fmt::format(",{},1", seed)));
}

}  // namespace
}  // namespace clogflow::test
