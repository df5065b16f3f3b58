// How far a disturbance of known decay is felt in a grid, and how far the neck is expected to be.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "coupling/channel_shape.hpp"
#include "coupling/duct_flow.hpp"
#include "coupling/flow_reach.hpp"
#include "tests/coupling/flow_scene.hpp"

namespace clog {
namespace {

/// Developed duct flow and a disturbance along y that halves over `half` upstream of the narrowing, where it is the
/// mean velocity.
FlowGrid disturbed_flow(const Scene& scene, double half) {
  const DuctFlow duct(scene.geometry.channel_width, scene.geometry.neck_height);
  const double v = scene.flow.mean_velocity, narrowing = -narrowing_length(scene);
  FlowGrid grid;
  grid.spacing = 10e-6;
  grid.origin = Vec3(channel_start(scene) + 5e-6, -scene.geometry.channel_width / 2 + 5e-6, 5e-6);
  grid.points = {static_cast<int>((narrowing - channel_start(scene)) / grid.spacing), 40, 10};
  const std::size_t count = static_cast<std::size_t>(grid.points[0]) * 400;
  grid.velocity.assign(3 * count, 0.0f);
  grid.solid.assign(count, 0);
  for (int k = 0; k < 10; ++k)
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < grid.points[0]; ++i) {
        const Vec3 at = grid.origin + grid.spacing * Vec3(i, j, k);
        grid.velocity[3 * grid.index(i, j, k)] = static_cast<float>(v * duct(at.y(), at.z()));
        grid.velocity[3 * grid.index(i, j, k) + 1] = static_cast<float>(v * std::exp2((at.x() - narrowing) / half));
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

}  // namespace
}  // namespace clog
