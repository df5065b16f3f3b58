// A clog that is proved to be at rest stays: what a run that ends there says, one that goes on finds too.
#include <gtest/gtest.h>

#include "dem/run/rest_proof.hpp"
#include "tests/dem/channel_scene.hpp"

namespace clogflow::test {
namespace {

Scene stopping_scene(Overrides more = {}) {
  more.insert(more.begin(), {"particles.diameter=47 um", "geometry.channel_length=300 um", "inlet.start=flowing",
                             "inlet.strain=2", "time.end=400 ms", "output.snapshot_interval=0 s"});
  return cheap_paper_scene(more);
}

RunData run(const Scene& scene, std::uint64_t seed) {
  const FlowGrid grid = synthetic_flow(scene);
  return Simulation(scene, &grid, seed).run();
}

void expect_permanent(const Overrides& law) {
  const auto scene = [&](Overrides protocol) {
    protocol.insert(protocol.end(), law.begin(), law.end());
    return stopping_scene(protocol);
  };
  const Scene stops = scene({"unclog.protocol=stop"}), goes_on = scene({"unclog.protocol=none"});
  for (const std::uint64_t seed : {1, 2, 3}) {
    const RunData stopped = run(stops, seed);
    ASSERT_TRUE(stopped.record.clogged_at && stopped.record.clog_proved.value_or(false)) << "seed " << seed;
    EXPECT_LT(stopped.end_time, 0.3);
    EXPECT_EQ(stopped.end_time, *stopped.record.clogged_at);
    // 100 ms later, 10 tau, nothing else has passed.
    EXPECT_EQ(run(goes_on, seed).passages.time, stopped.passages.time) << "seed " << seed;
  }
}

TEST(RestProof, WhatStopsTheRunIsPermanent) { expect_permanent({}); }

TEST(RestProof, OfSpheresThatStickToo) {
  // The pull-off force is the drag of a sphere in the neck.
  expect_permanent({"contact.law=jkr", "contact.surface_energy=0.29 mJ/m2"});
}

TEST(RestProof, AFlowIsNotAtRestAndNoiseAllowsNone) {
  for (const char* noise : {"drag.fluctuation.strength=0", "drag.fluctuation.strength=1e-9"}) {
    const Scene scene =
        stopping_scene({"unclog.protocol=none", noise, "drag.fluctuation.time=5 ms", "time.end=250 ms"});
    const FlowGrid grid = synthetic_flow(scene);
    Simulation simulation(scene, &grid, 1);
    simulation.fill({});
    EXPECT_FALSE(rests_for_good(simulation.state())) << "flowing";
    while (simulation.time() < 0.25) simulation.compute_forces(), simulation.record(), simulation.advance();
    simulation.compute_forces();
    EXPECT_EQ(rests_for_good(simulation.state()), std::string(noise).ends_with("=0")) << noise;
  }
}

TEST(RestProof, AnInletThatIsOnlySlowMayStillFeedTheClog) {
  for (const char* rate : {"inlet.rate=0 1/s", "inlet.rate=1 1/s"}) {
    const Scene scene = stopping_scene({"unclog.protocol=none", "inlet.strain=0.5", rate});
    const FlowGrid grid = synthetic_flow(scene);
    Simulation simulation(scene, &grid, 1);
    simulation.fill({});
    while (simulation.time() < 0.25) simulation.compute_forces(), simulation.record(), simulation.advance();
    simulation.compute_forces();
    const Particles& p = simulation.state().particles;
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (p[i].x >= 0) continue;
      ASSERT_LT(std::sqrt(dot(p[i].velocity(), p[i].velocity())), 1e-5 * scene.flow_speed()) << rate;
    }
    EXPECT_EQ(rests_for_good(simulation.state()), std::string(rate).ends_with("=0 1/s")) << rate;
  }
}

}  // namespace
}  // namespace clogflow::test
