// clog run --until: the same first seeds count, on any number of ranks, with and without interruptions.
#include <algorithm>
#include <set>

#include <gmock/gmock.h>

#include "postprocess/summary/stopping_rule.hpp"
#include "tests/faults/mpi_job.hpp"

namespace clogflow::test {
namespace {

using testing::HasSubstr;

constexpr std::uint64_t all = 8, enough = 4;

class Until : public testing::Test {
protected:
  /// All seeds without a rule; the rule is the passages of the first four, those of a release aside.
  void run_all() {
    ASSERT_EQ(job_.complete("all", fmt::format("1-{}", all)), "");
    std::int64_t passages = 0;
    for (std::uint64_t seed = 1; seed <= enough; ++seed) {
      const auto off = read_run_file(job_.path("all") / run_file_name(seed)).passages.friction_off;
      passages += std::count(off.begin(), off.end(), 0);
    }
    rule_ = fmt::format("passages>={}", passages);
  }

  std::vector<std::string> words(const std::string& out, const std::string& rule,
                                 const std::string& seeds = "1-8") const {
    return {"run",     job_.path("scene.toml"),
            "--flow",  job_.path("flow.h5"),
            "--out",   job_.path(out),
            "--seeds", seeds,
            "--until", rule};
  }

  Program start(const std::string& out, const std::string& rule, const std::string& seeds = "1-8") const {
    return {words(out, rule, seeds), job_.path("log_" + out)};
  }

  std::set<std::uint64_t> counted(const std::string& out) const {
    std::set<std::uint64_t> seeds;
    for (std::uint64_t seed = 1; seed <= all; ++seed)
      if (std::filesystem::exists(job_.path(out) / run_file_name(seed))) seeds.insert(seed);
    return seeds;
  }

  void expect_first_four(const std::string& out) const {
    EXPECT_EQ(counted(out), (std::set<std::uint64_t>{1, 2, 3, 4})) << out;
    for (const auto& entry : std::filesystem::directory_iterator(job_.path(out)))
      EXPECT_THAT(entry.path().extension().string(), testing::AnyOf(".h5", ".xmf", ".csv")) << entry.path();
    for (const std::uint64_t seed : counted(out)) EXPECT_TRUE(job_.result(out, seed) == job_.result("all", seed));
  }

  SmallJob job_;
  std::string rule_;
};

TEST_F(Until, TheSmallestNumberOfFirstSeedsThatMeetsTheRule) {
  ASSERT_NO_FATAL_FAILURE(run_all());
  const Program program = start("one", rule_);
  EXPECT_EQ(program.wait(), 0);
  EXPECT_THAT(program.said(), HasSubstr(rule_ + " is met by the first 4 of 8 seeds, passages = "));
  expect_first_four("one");
  // One process has nothing to do ahead of the decision.
  EXPECT_FALSE(std::filesystem::exists(job_.path("one/ahead_0005.h5")));
}

TEST_F(Until, ThreeRanksDecideTheSameAndWhatTheyDidAheadDoesNotCount) {
  ASSERT_NO_FATAL_FAILURE(run_all());
  MpiJob mpi({"-np", "3"}, words("three", rule_), job_.path("log_three"));
  EXPECT_EQ(mpi.wait(), 0) << mpi.said();
  EXPECT_THAT(mpi.said(), HasSubstr("is met by the first 4 of 8 seeds"));
  // Seeds that nobody needs are left to nobody.
  EXPECT_THAT(mpi.said(), testing::Not(HasSubstr("left to other calls")));
  expect_first_four("three");
  const Program stats({"stats", job_.path("three"), "--out", job_.path("stats"), "--threshold", "1 ms"},
                      job_.path("log_stats"));
  EXPECT_EQ(stats.wait(), 0) << stats.said();
  EXPECT_THAT(stats.said(), HasSubstr(": 4 seeds, "));
}

TEST_F(Until, SeedsThatAnotherCallHasAreTakenWhenTheyAreDone) {
  ASSERT_NO_FATAL_FAILURE(run_all());
  const Program first = start("two", rule_);
  const Program second(words("two", rule_), job_.path("log_second"));
  EXPECT_EQ(first.wait(), 0) << first.said();
  EXPECT_EQ(second.wait(), 0) << second.said();
  const Program last = start("two", rule_);
  EXPECT_EQ(last.wait(), 0) << last.said();
  EXPECT_THAT(last.said(), HasSubstr("is met by the first 4 of 8 seeds"));
  expect_first_four("two");
}

TEST_F(Until, KilledAndCalledAgainItDecidesTheSame) {
  ASSERT_NO_FATAL_FAILURE(run_all());
  std::mt19937 random{7};
  for (int call = 0; call < 6; ++call) {
    const Program program = start("killed", rule_);
    sleep_ms(static_cast<int>(random() % 400));
    program.send(call % 2 ? SIGKILL : SIGTERM);
    program.wait();
  }
  auto without = words("killed", rule_);
  without.emplace_back("--no-mpi");
  for (const auto& [options, call] : {std::pair{std::vector<std::string>{"-np", "3"}, words("killed", rule_)},
                                      std::pair{std::vector<std::string>{"--enable-recovery", "-np", "3"}, without}}) {
    MpiJob mpi(options, call, job_.path("log_killed"));
    for (int k = 0; k < 2000 && mpi.ranks().size() < 3 && !mpi.ended(); ++k) sleep_ms(1);
    if (!mpi.ended() && !mpi.ranks().empty()) ::kill(mpi.ranks().back(), SIGKILL);
    mpi.wait();
  }
  const Program last = start("killed", rule_);
  EXPECT_EQ(last.wait(), 0) << last.said();
  expect_first_four("killed");
}

TEST_F(Until, AStricterRuleGoesOnAndOneThatIsNotMetSaysSo) {
  ASSERT_NO_FATAL_FAILURE(run_all());
  ASSERT_EQ(start("one", rule_).wait(), 0);
  const Program strict = start("one", "passages>=1e6");
  EXPECT_EQ(strict.wait(), 1);
  EXPECT_THAT(strict.said(), HasSubstr("clog: passages>=1e6 is not met by 8 of 8 seeds, passages = "));
  EXPECT_THAT(strict.said(), HasSubstr(": give more --seeds\n"));
  EXPECT_EQ(counted("one").size(), all);
  for (std::uint64_t seed = 1; seed <= all; ++seed) EXPECT_TRUE(job_.result("one", seed) == job_.result("all", seed));
}

TEST_F(Until, WithoutTheRuleWhatWasDoneAheadCounts) {
  ASSERT_EQ(job_.complete("all", "3"), "");
  std::filesystem::create_directories(job_.path("ahead"));
  std::filesystem::copy_file(job_.path("all") / run_file_name(3), job_.path("ahead/ahead_0003.h5"));
  EXPECT_EQ(job_.complete("ahead", "1-3"), "");
  EXPECT_EQ(counted("ahead"), (std::set<std::uint64_t>{1, 2, 3}));
  EXPECT_FALSE(std::filesystem::exists(job_.path("ahead/ahead_0003.h5")));
}

TEST_F(Until, RanksThatUsedAllSeedsSaySoAndFail) {
  MpiJob mpi({"-np", "3"}, words("all_used", "passages>=1e6", "1-3"), job_.path("log_all_used"));
  EXPECT_NE(mpi.wait(), 0);
  EXPECT_THAT(mpi.said(), HasSubstr("clog: passages>=1e6 is not met by 3 of 3 seeds, passages = "));
  EXPECT_THAT(mpi.said(), HasSubstr(": give more --seeds\n"));
}

TEST_F(Until, WhatOneRankCannotWriteEndsTheCallOfAll) {
  ASSERT_NO_FATAL_FAILURE(run_all());
  std::filesystem::create_directories(job_.path("cannot/run_0002.xmf/taken"));
  for (const int seed : {1, 2, 3, 4})
    std::filesystem::copy_file(job_.path("all") / run_file_name(seed),
                               job_.path("cannot") / fmt::format("ahead_{:04d}.h5", seed));
  MpiJob mpi({"--timeout", "60", "-np", "3"}, words("cannot", rule_), job_.path("log_cannot"));
  EXPECT_EQ(mpi.wait(), 1) << mpi.said();
  EXPECT_THAT(mpi.said(), HasSubstr("run_0002.xmf (cannot be written"));
}

TEST_F(Until, EveryPointOfASweepDecidesForItself) {
  auto arguments = words("sweep", "passages>=1");
  arguments.insert(arguments.end(), {"--sweep", "contact.friction.rolling=0.3,0.6"});
  const Program program(arguments, job_.path("log"));
  EXPECT_EQ(program.wait(), 0) << program.said();
  for (const char* value : {"0.3", "0.6"}) {
    const std::string point = fmt::format("contact.friction.rolling={}", value);
    EXPECT_THAT(program.said(), HasSubstr(point + ": passages>=1 is met by the first "));
    EXPECT_GE(counted("sweep/" + point).size(), 1u);
    EXPECT_LT(counted("sweep/" + point).size(), all);
  }
}

TEST_F(Until, ARuleThatIsNoneIsRefusedBeforeAnythingRuns) {
  const Program program = start("none", "burst>=10");
  EXPECT_EQ(program.wait(), 1);
  EXPECT_THAT(program.said(), HasSubstr("clog: --until burst>=10 (must bound bursts, arrests, passages, releases or "
                                        "relative_error(...))\n"));
  EXPECT_FALSE(std::filesystem::exists(job_.path("none")));
}

}  // namespace
}  // namespace clogflow::test
