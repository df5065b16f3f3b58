// Whole runs of the paper's channel, cheap numerics: filling, coming to rest, staying there, and the
// same bits from the same seed. Slow: labelled so.
#include <gtest/gtest.h>

#include "coupling/base/quantile.hpp"
#include "tests/dem/channel_scene.hpp"

namespace clogflow::test {
namespace {

struct Filled {
  std::size_t particles;
  double packing;
};

Filled fill(const Overrides& overrides) {
  Overrides all{"time.end=1 us", "output.series_interval=1 us"};
  all.insert(all.end(), overrides.begin(), overrides.end());
  const Scene scene = cheap_paper_scene(all);
  const FlowGrid grid = synthetic_flow(scene);
  Simulation simulation(scene, &grid, 1);
  const RunData run = simulation.run();
  // Contacts of a pack at rest sit near 0.015 d at E = 3 MPa, the deepest a little beyond.
  EXPECT_LT(run.series.largest_overlap.back(), 0.03 * scene.particles.diameter)
      << "filling must not store energy that later explodes";
  return {simulation.particles().size(), run.series.packing_fraction.back()};
}

TEST(FilledStart, ReachesThePapersThousandParticles) {
  const Filled filled = fill({});
  // The paper: "about 1000" and about 0.5, with shaken packs; static ones hold 0.40 to 0.45.
  EXPECT_NEAR(static_cast<double>(filled.particles), 1000, 150);
  EXPECT_GT(filled.packing, 0.40);
  EXPECT_LT(filled.packing, 0.50);
}

TEST(FilledStart, ReachesThePapersSixtyLargeParticles) {
  const Filled filled = fill({"particles.diameter=80 um"});
  EXPECT_NEAR(static_cast<double>(filled.particles), 60, 12);
  EXPECT_GT(filled.packing, 0.34);
  EXPECT_LT(filled.packing, 0.50);
}

double slow_share(const Particles& p, double speed) {
  const auto slow =
      std::ranges::count_if(p.states, [&](const ParticleState& s) { return std::hypot(s.vx, s.vy, s.vz) < speed; });
  return static_cast<double>(slow) / static_cast<double>(p.size());
}

TEST(ClogWithoutRelease, ComesToRestAndStays) {
  // D/d = 2 clogs at once. tau/50 and true masses: rest must not be an effect of cheap numerics.
  const Scene scene =
      cheap_paper_scene({"particles.diameter=50 um", "geometry.channel_length=300 um", "time.mass_scale=1",
                         "time.rotational_inertia_scale=1", "time.step_fraction=0.02", "unclog.protocol=none",
                         "time.end=0.4 s", "output.snapshot_interval=0 s"});
  const FlowGrid grid = synthetic_flow(scene);
  Simulation simulation(scene, &grid, 2);
  const RunData run = simulation.run();
  EXPECT_GE(slow_share(simulation.particles(), 1e-6), 0.99);
  ASSERT_FALSE(run.passages.time.empty() && run.series.time.empty());
  if (!run.passages.time.empty()) {
    EXPECT_LT(run.passages.time.back(), 0.3) << "it stays";
  }
  EXPECT_LT(run.series.speed_q99.back(), 1e-6);
}

TEST(SameSeed, GivesTheSameBits) {
  const Scene scene = short_channel_scene({"time.end=20 ms", "output.snapshot_interval=10 ms"});
  const FlowGrid grid = synthetic_flow(scene);
  const auto run = [&](std::uint64_t seed) { return Simulation(scene, &grid, seed).run(); };
  const RunData a = run(5), b = run(5), other = run(6);
  EXPECT_EQ(a.passages.time, b.passages.time);
  EXPECT_EQ(a.passages.id, b.passages.id);
  EXPECT_EQ(a.series.kinetic_energy, b.series.kinetic_energy);
  ASSERT_EQ(a.snapshots.size(), b.snapshots.size());
  EXPECT_EQ(a.snapshots.back().position, b.snapshots.back().position);
  EXPECT_EQ(a.snapshots.back().force, b.snapshots.back().force);
  EXPECT_NE(a.snapshots.back().position, other.snapshots.back().position);
}

TEST(Run, DissipatesWhatTheFlowPutsInAndNeverGains) {
  // Every term at work: what was dissipated may fall only by what springs of changing stiffness give
  // back, a small share of all; what is not dissipated sits in the particles' speed and the springs.
  const Scene scene = short_channel_scene({"time.end=20 ms", "output.series_interval=0.1 ms"});
  const FlowGrid grid = synthetic_flow(scene);
  const RunData run = Simulation(scene, &grid, 1).run();
  const auto& dissipated = run.series.dissipated;
  ASSERT_GT(dissipated.size(), 100u);
  double highest = 0, fall = 0;
  for (const double value : dissipated) {
    highest = std::max(highest, value);
    fall = std::max(fall, highest - value);
  }
  EXPECT_LT(fall, 0.01 * dissipated.back());
  EXPECT_GT(dissipated.back(), 0.8 * run.series.drag_work.back());
  EXPECT_LT(dissipated.back(), 1.05 * run.series.drag_work.back());
}

}  // namespace
}  // namespace clogflow::test
