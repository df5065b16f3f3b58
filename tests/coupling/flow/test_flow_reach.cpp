// How far a disturbance of known decay is felt in a grid, and how far the neck is expected to be.
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "coupling/flow/channel_drop.hpp"
#include "coupling/flow/flow_reach.hpp"
#include "coupling/flow/straight_flux.hpp"
#include "coupling/geometry/channel_shape.hpp"
#include "coupling/geometry/duct_flow.hpp"
#include "tests/coupling/flow_scene.hpp"
#include "tests/coupling/refusal.hpp"

namespace clogflow {
namespace {

/// Developed duct flow and a disturbance along y that halves over `half` upstream of the narrowing, where it is the
/// mean velocity.
FlowGrid disturbed_flow(const Scene& scene, double half) {
  const DuctFlow duct(scene.geometry.channel_width, scene.geometry.neck_height);
  const double v = scene.flow.mean_velocity, narrowing = -narrowing_length(scene.geometry);
  FlowGrid grid;
  grid.spacing = 10e-6;
  grid.origin = Vec3(channel_start(scene.geometry) + 5e-6, -scene.geometry.channel_width / 2 + 5e-6, 5e-6);
  grid.points = {static_cast<int>((narrowing - channel_start(scene.geometry)) / grid.spacing), 40, 10};
  const std::size_t count = static_cast<std::size_t>(grid.points[0]) * 400;
  grid.velocity.assign(3 * count, 0.0f);
  grid.solid.assign(count, 0);
  for (int k = 0; k < 10; ++k)
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < grid.points[0]; ++i) {
        const Vec3 at = grid.origin + grid.spacing * Vec3(i, j, k);
        grid.velocity[3 * grid.index(i, j, k)] = static_cast<float>(v * duct(at.y, at.z));
        grid.velocity[3 * grid.index(i, j, k) + 1] = static_cast<float>(v * std::exp2((at.x - narrowing) / half));
      }
  return grid;
}

TEST(FlowReach, OfAKnownDecayIsFoundToTheGridsSpacing) {
  const Scene scene = flow_scene();
  // A hundredth is left after log2(100) = 6.644 half-lengths.
  for (const double half : {30e-6, 60e-6})
    EXPECT_NEAR(measured_reach(disturbed_flow(scene, half), scene, 0.01), 6.644 * half, 11e-6) << half;
}

TEST(FlowReach, IsNothingInDevelopedFlowAndInfiniteWhereTheBeginningIsNot) {
  const Scene scene = flow_scene();
  FlowGrid flow = disturbed_flow(scene, 1e-6);
  EXPECT_EQ(measured_reach(flow, scene, 2.0), 0);
  flow.velocity[0] += static_cast<float>(scene.flow.mean_velocity);
  EXPECT_TRUE(std::isinf(measured_reach(flow, scene, 0.01)));
}

TEST(FlowReach, ExpectedIsOfTheSlowestSymmetricMode) {
  // 400 um / (2 pi) ln 100, and nothing where all is tolerated.
  EXPECT_NEAR(expected_reach(flow_scene(), 0.01), 4e-4 / (2 * std::numbers::pi) * 4.60517, 1e-9);
  EXPECT_EQ(expected_reach(flow_scene(), 1), 0);
}

TEST(StraightFlux, IsExactForAParabolaWhereverItsWallsAre) {
  // u = s (10 - s) from s = 0 to 10: 500 / 3.
  for (const double first : {0.01, 0.3, 0.5, 1.0}) {
    std::vector<double> values;
    double s = first;
    for (; s < 10; s += 1) values.push_back(s * (10 - s));
    EXPECT_NEAR(integral_between_walls(values, first, 10 - (s - 1)), 500.0 / 3, 1e-9) << first;
  }
}

/// Developed flow of the scene before the narrowing, times a wave along x; nothing from the
/// narrowing on.
FlowGrid wavering_flow(const Scene& scene, double amplitude) {
  FlowGrid grid;
  grid.points = {40, 80, 20};
  grid.spacing = 5e-6;
  grid.origin = Vec3(-narrowing_length(scene.geometry) - 150e-6, -197.5e-6, 2.5e-6);
  const DuctFlow duct(scene.geometry.channel_width, scene.geometry.neck_height);
  for (int k = 0; k < grid.points[2]; ++k)
    for (int j = 0; j < grid.points[1]; ++j)
      for (int i = 0; i < grid.points[0]; ++i) {
        const Vec3 x = grid.origin + grid.spacing * Vec3(i, j, k);
        const double wave = 1 + amplitude * std::sin(2 * std::numbers::pi * x.x / 70e-6);
        const auto u = static_cast<float>(scene.flow.mean_velocity * duct(x.y, x.z) * wave);
        grid.velocity.insert(grid.velocity.end(), {u, u / 2, 0});
        grid.solid.push_back(0);
      }
  return grid;
}

TEST(StraightFlux, TakesTheWaverOutBeforeTheNarrowingAndNothingBehind) {
  const Scene scene = flow_scene();
  const FlowGrid still = wavering_flow(scene, 0);
  FlowGrid grid = wavering_flow(scene, 0.02);
  const FlowGrid before = grid;
  EXPECT_NEAR(restore_flow_rate(grid, scene), 0.02, 5e-4);
  const double bend = -narrowing_length(scene.geometry);
  for (std::size_t at = 0; at < grid.solid.size(); ++at) {
    const std::size_t i = at % 40;
    const bool straight = i > 0 && grid.origin.x + static_cast<double>(i) * grid.spacing <= bend;
    for (int c = 0; c < 3; ++c) {
      const float wanted = straight ? still.velocity[3 * at + c] : before.velocity[3 * at + c];
      // The rule itself on 20 layers: 1e-4.
      ASSERT_NEAR(grid.velocity[3 * at + c], wanted, 2e-4 * std::abs(wanted) + 1e-12) << at;
    }
  }
  FlowGrid wrong = wavering_flow(scene, 0.2);
  EXPECT_THAT(refusal([&] { restore_flow_rate(wrong, scene); }), testing::HasSubstr("the flux through x = "));
}

// 400 and 100 um by 100 um: f Re = 72.93 and 56.92 (Shah and London) on hydraulic diameters of 160 and 100 um.
TEST(ChannelDrop, EstimatesTheDucts) {
  const Scene scene = flow_scene({"geometry.channel_length=2.5 mm", "geometry.neck_length=1 mm"});
  const double wide = 72.93 / 2 / (160e-6 * 160e-6) * 1.8e-3 * 5e-3 * 2.5e-3,
               neck = 56.92 / 2 / (100e-6 * 100e-6) * 1.8e-3 * 20e-3 * 1e-3;
  // The narrowing, 87 um long, has between one and the other.
  EXPECT_GT(*estimated_pressure_drop(scene), wide + neck);
  EXPECT_LT(*estimated_pressure_drop(scene), wide + 1.087 * neck);
}

TEST(ChannelDrop, OfAFileThatDoesNotTellIsRefused) {
  const Scene scene = flow_scene({"flow.compliance=1e-15 m3/Pa", "drag.velocity=mixture", "drag.enabled=true"});
  FlowGrid flow;
  EXPECT_THAT(refusal([&] { solved_pressure_drop(flow, scene); }),
              testing::HasSubstr("flow.compliance (needs the pressure drop of the empty channel"));
  flow.record.pressure_drop = 20.0;
  EXPECT_EQ(solved_pressure_drop(flow, scene), *channel_pressure_drop(flow, scene));
}

// A channel ten times as long as it is wide adds what a duct adds.
TEST(FlowReach, ALongerChannelAddsItsDevelopedPressureDrop) {
  const Scene solved = flow_scene({"geometry.channel_length=500 um"}),
              longer = flow_scene({"geometry.channel_length=2.5 mm"});
  FlowGrid flow;
  EXPECT_FALSE(channel_pressure_drop(flow, longer));
  flow.record.pressure_drop = 20.0;
  EXPECT_DOUBLE_EQ(*channel_pressure_drop(flow, solved), 20);
  // 400 x 100 um: f Re = 72.93, D = 160 um; 1.8 mPa s, 5 mm/s, 2 mm.
  EXPECT_NEAR(*channel_pressure_drop(flow, longer) - 20, 72.93 / 2 / (160e-6 * 160e-6) * 1.8e-3 * 5e-3 * 2e-3, 0.01);
}

}  // namespace
}  // namespace clogflow
