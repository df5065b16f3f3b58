#include "coupling/channel_geometry.hpp"

#include <array>
#include <map>
#include <numbers>
#include <tuple>

#include <gmock/gmock.h>
#include <Eigen/Geometry>

#include "coupling/channel_shape.hpp"
#include "tests/coupling/flow_scene.hpp"

namespace clog {
namespace {

Vec3 area_vector(const Triangle& t) {
  return 0.5 * (t.corner[1] - t.corner[0]).cross(t.corner[2] - t.corner[0]);
}

using Key = std::tuple<long, long, long>;

Key key(const Vec3& p) {  // to a nanometre
  return {std::lround(p.x() * 1e9), std::lround(p.y() * 1e9), std::lround(p.z() * 1e9)};
}

// How often each directed edge occurs, less the opposite one: 0 inside a closed surface.
std::map<std::pair<Key, Key>, int> open_edges(const Walls& walls) {
  std::map<std::pair<Key, Key>, int> edges;
  for (const Triangle& t : walls) {
    for (int i = 0; i < 3; ++i) {
      const Key a = key(t.corner[i]), b = key(t.corner[(i + 1) % 3]);
      if (edges.contains({b, a})) {
        if (--edges[{b, a}] == 0) edges.erase({b, a});
      } else {
        ++edges[{a, b}];
      }
    }
  }
  return edges;
}

class ChannelGeometry : public testing::TestWithParam<const char*> {
protected:
  Scene scene = flow_scene({std::string("geometry.half_angle=") + GetParam()});
};

TEST_P(ChannelGeometry, IsClosedButForInletAndOutlet) {
  for (const auto& [edge, count] : open_edges(channel_walls(scene))) {
    const double xa = static_cast<double>(std::get<0>(edge.first)) * 1e-9;
    const double xb = static_cast<double>(std::get<0>(edge.second)) * 1e-9;
    EXPECT_EQ(count, 1);
    EXPECT_NEAR(xa, xb, 1e-9);
    const bool at_opening = std::abs(xa - channel_start(scene)) < 2e-9 ||
                            std::abs(xa - scene.geometry.neck_length) < 2e-9;
    EXPECT_TRUE(at_opening) << "a hole at x = " << xa;
  }
}

TEST_P(ChannelGeometry, NormalsPointIntoTheFluid) {
  for (const Triangle& t : channel_walls(scene)) {
    const Vec3 area = area_vector(t);
    ASSERT_GT(area.norm(), 0);
    const Vec3 inside = (t.corner[0] + t.corner[1] + t.corner[2]) / 3 + 1e-7 * area.normalized();
    EXPECT_GT(inside.z(), 0);
    EXPECT_LT(inside.z(), scene.geometry.neck_height);
    EXPECT_LT(std::abs(inside.y()), channel_width_at(scene, inside.x()) / 2);
  }
}

// Gauss: the openings and the walls bound the channel, so sum of x.A gives three volumes.
TEST_P(ChannelGeometry, EnclosesTheVolumeOfTheChannel) {
  const auto& g = scene.geometry;
  double sum = 0;
  for (const Triangle& t : channel_walls(scene)) sum -= t.corner[0].dot(area_vector(t)) / 3;
  sum += g.neck_length * g.neck_width * g.neck_height / 3;
  sum -= channel_start(scene) * g.channel_width * g.neck_height / 3;
  const double volume =
      channel_volume(scene, channel_start(scene), 0) + g.neck_length * g.neck_width * g.neck_height;
  EXPECT_NEAR(sum / volume, 1, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Angles, ChannelGeometry,
                         testing::Values("\"10 deg\"", "\"60 deg\"", "\"90 deg\""));

// D = 1e-4 m: 4 D x 10 D before the narrowing of 1.5 D / tan 60, slanted walls of 1.5 D / sin 60.
TEST(ChannelGeometryAreas, AreThoseByHand) {
  double slanted = 0, floor = 0, side = 0;
  for (const Triangle& t : channel_walls(flow_scene())) {
    const Vec3 area = area_vector(t);
    const Vec3 n = area.normalized();
    if (n.z() > 0.5) floor += area.norm();
    if (std::abs(n.y()) > 0.9) side += area.norm();
    if (std::abs(n.x()) > 0.1) {
      slanted += area.norm();
      EXPECT_NEAR(n.x(), -std::sin(std::numbers::pi / 3), 1e-12);
    }
  }
  EXPECT_NEAR(slanted, 2 * 1.7320508e-8, 1e-15);
  EXPECT_NEAR(side, 2 * (10 + 1) * 1e-8, 1e-15);
  EXPECT_NEAR(floor, (40 + 2.5 * 0.8660254 + 1) * 1e-8, 1e-14);
}

}  // namespace
}  // namespace clog
