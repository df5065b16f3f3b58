// Runs whose flow is not steady: what follows the flow's clock, and what goes back.
#include <cmath>

#include <gmock/gmock.h>

#include "tests/faults/small_channel.hpp"

namespace clogflow::test {
namespace {

RunData run_of(const Overrides& overrides, std::uint64_t seed = 3) {
  const Scene scene = small_channel(overrides);
  const FlowGrid grid = synthetic_flow(scene);
  return Simulation(scene, &grid, seed).run();
}

/// Twice as fast by a table of one row, or by the mean velocity: the same suspension, but for the filling.
TEST(DrivenFlow, AFactorOfTwoIsTwiceTheRate) {
  const ScratchFile table("time,factor\n0,2\n");
  const Overrides empty = {"inlet.start=empty", "unclog.protocol=none", "time.step_fraction=0.02", "time.end=60 ms"};
  const auto with = [&](Overrides more) {
    more.insert(more.end(), empty.begin(), empty.end());
    return run_of(more);
  };
  const RunData doubled = with({"flow.oscillation.table=" + table.name()}), steady = with({});
  EXPECT_EQ(doubled.series.flow_factor, std::vector<double>(doubled.series.time.size(), 2.0));
  EXPECT_TRUE(steady.series.flow_factor.empty());
  ASSERT_GE(steady.passages.time.size(), 1u);
  ASSERT_GE(doubled.passages.time.size(), 1u);
  // The first particle comes in at the same place, at the speed that the flow has there, and nothing is in its way.
  EXPECT_EQ(doubled.passages.id[0], steady.passages.id[0]);
  EXPECT_NEAR(doubled.passages.time[0], steady.passages.time[0] / 2, 0.02 * steady.passages.time[0]);
}

/// A pause of any length is no clog: nothing passes, but nothing would in as little flow.
TEST(DrivenFlow, WaitsCountWhatTheFlowCarries) {
  const ScratchFile pause("time,factor\n0,0\n");
  const RunData run = run_of({"flow.oscillation.table=" + pause.name(), "time.end=40 ms"});
  EXPECT_EQ(run.releases.off.size(), 0u);
  EXPECT_EQ(run.passages.time.size(), 0u);
  const ScratchFile half("time,factor\n0,0.5\n");
  const RunData slow = run_of({"flow.oscillation.table=" + half.name(), "time.end=40 ms", "unclog.shortcut=false"});
  ASSERT_GE(slow.releases.off.size(), 1u);
  // 3 ms of the mean flow without a passage, and 1.5 ms of it without friction.
  EXPECT_GE(slow.releases.off[0], 0.006);
  EXPECT_NEAR(slow.releases.on[0] - slow.releases.off[0], 0.003, 1e-5);
}

TEST(DrivenFlow, InflowOfAConcentrationFollowsTheFlow) {
  const ScratchFile ramp("time,factor\n0,0\n0.1,1\n");
  const Scene scene = short_channel_scene({"inlet.start=empty", "unclog.protocol=none", "inlet.concentration=0.02",
                                           "flow.oscillation.table=" + ramp.name()});
  const FlowGrid grid = synthetic_flow(scene);
  const Model model = make_model(scene, &grid, {});
  Fluid fluid = make_fluid(scene, &grid);
  for (int k = 0; k < 1000; ++k) {
    fluid.drive().prescribe(1e-4 * (k + 0.5), true);
    fluid.drive().advance(1e-4);
  }
  EXPECT_NEAR(fluid.drive().carried(0), 0.05, 1e-12);
  Inlet inlet(model);
  Particles particles;
  RandomStream random(3);
  for (int k = 0; k < 200; ++k) inlet.insert(particles, fluid, random, 0.1);
  // 0.02 x 5 mm/s x 400 x 100 um x 0.05 s over pi / 6 (33 um)^3 is 10.6
  EXPECT_EQ(particles.size(), 11u);
}

TEST(DrivenFlow, WhatGoesBackThroughTheNeckCountsAnew) {
  // A ball in a box of liquid that moves a millimetre there, back and there again.
  Scene scene = laboratory_scene({.youngs_modulus = 1e6, .density = 1000, .diameter = 1e-4}, 1e-5);
  scene.box.present = true;
  scene.box.min = {-5e-3, -5e-3, -5e-3}, scene.box.max = {5e-3, 5e-3, 5e-3};
  scene.fluid.viscosity = 1e-3, scene.fluid.density = 1000;
  scene.drag.enabled = true;
  scene.flow.source = FlowSource::uniform;
  scene.flow.velocity = {1e-2, 0, 0};
  const ScratchFile table("time,factor\n0,1\n0.0999,1\n0.1001,-1\n0.1999,-1\n0.2001,1\n");
  scene.flow.oscillation.table = table.name();
  scene.passages.plane = 0.5e-3;
  scene.time.end = 0.3;
  const ScratchFile particles("x,y,z\n0.0001,0,0\n");
  scene.particles.initial = particles.name();
  const RunData run = Simulation(scene, nullptr, 1).run();
  ASSERT_EQ(run.passages.time.size(), 2u);
  EXPECT_NEAR(run.passages.time[0], 0.04, 2e-3);
  EXPECT_NEAR(run.passages.time[1], 0.24, 2e-3);
  EXPECT_EQ(run.passages.id, (std::vector<std::int64_t>{0, 0}));
}

/// integral q dt until the first passage [s]
double carried_until_first(const RunData& run) {
  double sum = 0;
  const auto& s = run.series;
  for (std::size_t k = 0; k + 1 < s.time.size() && s.time[k] < run.passages.time.at(0); ++k)
    sum += s.flow_factor[k] * (std::min(s.time[k + 1], run.passages.time[0]) - s.time[k]);
  return sum;
}

/// Rate invariance: without inertia and with rigid contacts the same particles come first, when as much has flown. A
/// pack that a pressure drives responds together, in (1 + its resistance over the channel's) m/c, here up to a fifth of
/// that.
TEST(DrivenFlow, ADriveThatNeverGoesBackOnlyRelabelsTime) {
  const auto run = [](Overrides more, std::uint64_t seed) {
    more.insert(more.end(), {"drag.velocity=mixture", "time.integrator=implicit_drag", "unclog.protocol=none",
                             "output.series_interval=0.02 ms", "output.snapshot_interval=0 s", "time.end=15 ms",
                             "contact.youngs_modulus=30 MPa", "inlet.start=flowing", "inlet.strain=1"});
    return run_of(more, seed);
  };
  for (const std::uint64_t seed : {1, 2, 3}) {
    const RunData steady = run({}, seed);
    ASSERT_GE(steady.passages.time.size(), 1u) << seed;
    for (const RunData& driven : {run({"flow.oscillation.amplitude=0.7", "flow.oscillation.frequency=300 Hz"}, seed),
                                  run({"flow.drive=pressure", "flow.pressure_drop=200 Pa"}, seed),
                                  run({"flow.compliance=1e-14 m3/Pa"}, seed)}) {
      ASSERT_GE(driven.passages.time.size(), 1u) << seed;
      EXPECT_EQ(driven.passages.id[0], steady.passages.id[0]) << seed;
      EXPECT_NEAR(carried_until_first(driven) / steady.passages.time[0], 1, 0.25) << seed;
    }
  }
}

TEST(DrivenFlow, StepsAreLimitedByTheFastestFlow) {
  const auto limits = [](const Overrides& more) {
    return expected_limits(make_model(short_channel_scene(more), nullptr, {}), {});
  };
  const StepLimits steady = limits({}),
                   fast = limits({"flow.oscillation.amplitude=1", "flow.oscillation.frequency=10 Hz"});
  EXPECT_DOUBLE_EQ(fast.passing, steady.passing / 2);
  // Hertz: overlap goes with the load to 2/3.
  EXPECT_NEAR(fast.expected_overlap / steady.expected_overlap, std::cbrt(4.0), 1e-9);
}

}  // namespace
}  // namespace clogflow::test
