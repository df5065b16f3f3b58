// A copy that is not pushed is the run itself; one that is differs by no more than its push.
#include <cmath>

#include <gmock/gmock.h>

#include "tests/faults/small_channel.hpp"
#include "tests/statistics/pushed_copies.hpp"

namespace clogflow::test {
namespace {

Scene rewinding() {
  return small_channel({"inlet.start=flowing", "unclog.protocol=rewind", "inlet.strain=1", "time.end=60 ms"});
}

TEST(PushedCopies, MoveEachCentreByAtMostThePush) {
  const Scene scene = rewinding();
  const FlowGrid flow = synthetic_flow(scene);
  Simulation run(scene, &flow, 1);
  run.fill({});
  const Particles before = run.particles();
  push(run.particles(), 1e-12, RandomStream(1));
  double largest = 0;
  for (std::size_t i = 0; i < before.size(); ++i)
    largest = std::max(largest, std::abs(run.particles()[i].y - before[i].y));
  EXPECT_GT(largest, 0.5e-12);
  EXPECT_LT(largest, 1.001e-12);
}

TEST(PushedCopies, AreTheRunItselfWithoutAPush) {
  const Scene scene = rewinding();
  const FlowGrid flow = synthetic_flow(scene);
  Simulation run(scene, &flow, 1);
  run.fill({});
  ASSERT_EQ(clogs(run), 0u);
  const std::string state = run.save();
  constexpr std::size_t within = 1000;
  const Future own = future_of({scene, &flow, 1, state, within}, 0, 0);
  while (clogs(run) == 0 && !step(run)) {
  }
  EXPECT_EQ(own.passed, run.data().passages.id);
  EXPECT_EQ(own.clogged, clogs(run) == 1);
  EXPECT_TRUE(own.clogged) << "the scene is to clog";
  EXPECT_EQ(alike(own, own), own.passed.size());
}

TEST(PushedCopies, AreLeftAfterThePassagesAskedFor) {
  const Scene scene = rewinding();
  const FlowGrid flow = synthetic_flow(scene);
  Simulation run(scene, &flow, 1);
  run.fill({});
  const Future first = future_of({scene, &flow, 1, run.save(), 1}, 3, 1e-12);
  EXPECT_EQ(first.passed.size(), 1u);
  EXPECT_FALSE(first.clogged);
}

TEST(PushedCopies, AreAlikeUntilTheFirstThatDiffers) {
  EXPECT_EQ(alike({{1, 2, 3}}, {{1, 2, 4}}), 2u);
  EXPECT_EQ(alike({{1, 2}}, {{1, 2, 4}}), 2u);
  EXPECT_EQ(alike({{5}}, {{1}}), 0u);
}

}  // namespace
}  // namespace clogflow::test
