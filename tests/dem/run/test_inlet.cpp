// The inlet: never an overlap at insertion, bounded attempts, counted refusals, a rate that is kept.
#include <gtest/gtest.h>

#include "dem/run/inlet.hpp"
#include "tests/dem/channel_scene.hpp"

namespace clogflow::test {
namespace {

/// The inlet alone, with particles that stay where they are put.
struct Bench {
  explicit Bench(const Scene& s)
      : scene(s), grid(synthetic_flow(s)), model(make_model(s, &grid, {})), fluid(make_fluid(s, &grid)), inlet(model) {}

  Scene scene;
  FlowGrid grid;
  Model model;
  Fluid fluid;
  Inlet inlet;
  Particles particles;
  Random random{3};
};

TEST(Inlet, NeverInsertsIntoAnotherOrAWall) {
  Bench bench(short_channel_scene());
  for (int k = 0; k < 200; ++k) bench.inlet.insert(bench.particles, bench.fluid, bench.random, 0);
  const Particles& p = bench.particles;
  ASSERT_GT(p.size(), 20u);
  EXPECT_LE(deepest_pair(p), 0);
  const double r = bench.scene.particles.diameter / 2;
  for (std::size_t i = 0; i < p.size(); ++i) {
    EXPECT_GE(p[i].x - r, channel_start(bench.scene.geometry));
    EXPECT_LE(std::abs(p[i].y) + r, bench.scene.geometry.channel_width / 2);
    EXPECT_GE(p[i].z - r, 0);
    EXPECT_LE(p[i].z + r, bench.scene.geometry.neck_height);
  }
}

TEST(Inlet, StartsParticlesWithTheFlow) {
  Bench bench(short_channel_scene());
  bench.inlet.insert(bench.particles, bench.fluid, bench.random, 0);
  const Particles& p = bench.particles;
  for (std::size_t i = 0; i < p.size(); ++i) EXPECT_EQ(p[i].vx, bench.fluid.field().at(p[i].x, p[i].y, p[i].z)[0]);
}

TEST(Inlet, WhenFullTriesABoundedNumberOfTimesAndCounts) {
  Bench bench(short_channel_scene());
  for (int k = 0; k < 300; ++k) bench.inlet.insert(bench.particles, bench.fluid, bench.random, 0);
  const auto full = bench.particles.size();
  const std::int64_t before = bench.inlet.refused();
  const int inserted = bench.inlet.insert(bench.particles, bench.fluid, bench.random, 0);
  // Four attempts for each of the 400/33 x 100/33 places side by side.
  EXPECT_EQ(bench.inlet.refused() - before + inserted, 4 * 36);
  EXPECT_LE(bench.particles.size(), full + 2);
}

TEST(Inlet, KeepsToARate) {
  Bench bench(short_channel_scene({"inlet.rate=1000 1/s"}));
  EXPECT_EQ(bench.inlet.insert(bench.particles, bench.fluid, bench.random, 0), 0);
  EXPECT_EQ(bench.inlet.insert(bench.particles, bench.fluid, bench.random, 0.0025), 3);
  EXPECT_EQ(bench.inlet.insert(bench.particles, bench.fluid, bench.random, 0.0025), 0);
  EXPECT_EQ(bench.inlet.insert(bench.particles, bench.fluid, bench.random, 0.0041), 2);
}

TEST(Inlet, ScattersWithoutOverlap) {
  Bench bench(cheap_paper_scene());
  bench.inlet.scatter(bench.particles, bench.random);
  const Particles& p = bench.particles;
  EXPECT_LE(deepest_pair(p), 0);
  const double solid = static_cast<double>(p.size()) * M_PI / 6 * std::pow(33e-6, 3);
  // 0.30 is asked for; beside walls three diameters apart random addition ends a little below.
  EXPECT_NEAR(solid / (1e-3 * 4e-4 * 1e-4), 0.28, 0.02);
}

TEST(Inlet, GivesIdsThatAreNeverUsedTwice) {
  Bench bench(short_channel_scene());
  bench.inlet.scatter(bench.particles, bench.random);
  bench.inlet.insert(bench.particles, bench.fluid, bench.random, 0);
  for (std::size_t i = 0; i < bench.particles.size(); ++i)
    EXPECT_EQ(bench.particles.id[i], static_cast<std::int64_t>(i));
}

}  // namespace
}  // namespace clogflow::test
