// Killed at any moment, asked to stop, started twice: the results are those of an undisturbed run.
#include <random>

#include <gmock/gmock.h>

#include "dem/run/checkpoint.hpp"
#include "tests/faults/program.hpp"

namespace clogflow::test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// What is saved of a seed: nothing, a state while filling, or one while running.
std::string saved_stage(const SmallJob& job, const std::string& out, std::uint64_t seed) {
  const auto file = job.path(out) / run_file_name(seed);
  const std::string state = text_of(std::filesystem::path(file).replace_extension(".state"));
  if (state.empty()) return "nothing";
  Scene scene = job.scene;
  scene.ensemble.seeds = {seed};
  Simulation simulation(scene, &job.flow, seed);
  simulation.resume(unpack_state(state).state);
  return simulation.data().series.time.empty() ? "filling" : "running";
}

TEST(Killed, ManyTimesWithTheSameBits) {
  const SmallJob job({"time.end=60 ms"});
  // A whole seed sets the measure, so that a slow machine gets as far between two kills.
  const auto before = std::chrono::steady_clock::now();
  ASSERT_EQ(job.complete("undisturbed", "1"), "");
  const std::chrono::duration<double, std::milli> whole = std::chrono::steady_clock::now() - before;
  const unsigned longest = std::max(40u, static_cast<unsigned>(0.6 * whole.count()));
  const int wanted = kills(16);
  std::mt19937 random(2024);
  std::map<std::string, int> stages;
  int killed = 0;
  std::uint64_t seed = 1;
  // From 0: in the start, while reading, while writing; to where a seed or two is done.
  for (int call = 0; call < 500 && killed < wanted; ++call) {
    const Program program = job.start("killed", "1-99");
    sleep_ms(static_cast<int>(random() % longest));
    program.send(SIGKILL);
    if (program.wait() == 0) break;
    ++killed;
    while (std::filesystem::exists(job.path("killed") / run_file_name(seed))) ++seed;
    ++stages[saved_stage(job, "killed", seed)];
  }
  ASSERT_EQ(killed, wanted) << "the job was done before";
  EXPECT_GE(stages["filling"], 1);
  EXPECT_GE(stages["running"], 1);
  const std::string met = fmt::format("1-{}", seed);
  ASSERT_EQ(job.complete("killed", met), "");
  ASSERT_EQ(job.complete("undisturbed", met), "");
  for (std::uint64_t k = 1; k <= seed; ++k)
    EXPECT_TRUE(job.result("killed", k) == job.result("undisturbed", k)) << "seed " << k;
  for (const auto& entry : std::filesystem::directory_iterator(job.path("killed")))
    EXPECT_THAT(entry.path().string(), Not(HasSubstr(".state")));
  fmt::print("seeds met {}, states left: nothing {}, filling {}, running {}\n", seed, stages["nothing"],
             stages["filling"], stages["running"]);
}

class Asked : public testing::TestWithParam<int> {};

TEST_P(Asked, ToStopItSavesAndEndsWithTheStatusOfShells) {
  const SmallJob job(longer);
  const Program program = job.start("stopped", "1-2");
  ASSERT_TRUE(appears(job.path("stopped/run_0001.state")));
  program.send(GetParam());
  program.send(GetParam());  // in haste
  EXPECT_EQ(program.wait(), 128 + GetParam());
  EXPECT_THAT(program.said(), HasSubstr("seed 1: stopped; its state is saved"));
  EXPECT_THAT(program.said(), Not(HasSubstr("seed 2")));
  EXPECT_FALSE(std::filesystem::exists(job.path("stopped/run_0001.h5")));
  EXPECT_FALSE(std::filesystem::exists(job.path("stopped/run_0001.lock")));
  ASSERT_EQ(job.complete("stopped", "1"), "");
  ASSERT_EQ(job.complete("undisturbed", "1"), "");
  EXPECT_TRUE(job.result("stopped", 1) == job.result("undisturbed", 1));
}

INSTANTIATE_TEST_SUITE_P(Signals, Asked, testing::Values(SIGTERM, SIGINT));

TEST(Killed, RightAfterItWroteItsFileItLeavesNoStateForEver) {
  const SmallJob job;
  ASSERT_EQ(job.complete("out", "1"), "");
  write_file(job.path("out/run_0001.state"), "left over");
  ASSERT_EQ(job.complete("out", "1"), "");
  EXPECT_FALSE(std::filesystem::exists(job.path("out/run_0001.state")));
}

TEST(TwoCalls, OnOneDirectoryShareTheSeeds) {
  const SmallJob job({"time.end=60 ms"});
  const Program first = job.start("out", "1-2");
  ASSERT_TRUE(appears(job.path("out/run_0001.state")));
  first.send(SIGSTOP);
  const Program second(
      {"run", job.path("scene.toml"), "--flow", job.path("flow.h5"), "--out", job.path("out"), "--seeds", "1-2"},
      job.path("log_of_second"));
  // It neither does what the first is at work on nor waits for it.
  EXPECT_EQ(second.wait(), 0) << second.said();
  EXPECT_THAT(second.said(), Not(HasSubstr("seed 1: ")));
  EXPECT_THAT(second.said(), HasSubstr("seed 2: "));
  EXPECT_THAT(second.said(),
              HasSubstr("1 of 2 seeds are left to other calls that are at work on them, such as process "));
  first.send(SIGCONT);
  EXPECT_EQ(first.wait(), 0) << first.said();
  EXPECT_THAT(first.said(), Not(HasSubstr("seed 2: ")));
  ASSERT_EQ(job.complete("undisturbed", "1-2"), "");
  for (const std::uint64_t seed : {1, 2})
    EXPECT_TRUE(job.result("out", seed) == job.result("undisturbed", seed)) << seed;
}

TEST(TwoCalls, ALockOfADeadProcessHoldsNothing) {
  const SmallJob job;
  write_file(job.path("out/run_0001.lock"), "");
  EXPECT_EQ(job.complete("out", "1"), "");
  EXPECT_FALSE(std::filesystem::exists(job.path("out/run_0001.lock")));
}

}  // namespace
}  // namespace clogflow::test
