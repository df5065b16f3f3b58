#include "coupling/geometry/channel_geometry.hpp"

#include <array>
#include <map>
#include <numbers>
#include <ostream>
#include <tuple>

#include <gmock/gmock.h>
#include <Eigen/Geometry>

#include "coupling/geometry/channel_shape.hpp"
#include "coupling/geometry/polygon.hpp"
#include "tests/coupling/flow_scene.hpp"
#include "tests/coupling/refusal.hpp"

namespace clogflow {
namespace {

Vec3 area_vector(const Triangle& t) { return 0.5 * cross(t.corner[1] - t.corner[0], t.corner[2] - t.corner[0]); }

using Key = std::tuple<long, long, long>;

Key key(const Vec3& p) {  // to a nanometre
  return {std::lround(p.x * 1e9), std::lround(p.y * 1e9), std::lround(p.z * 1e9)};
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

struct Shape {
  const char* name;
  Overrides overrides;
};

void PrintTo(const Shape& shape, std::ostream* out) { *out << shape.name; }

class ChannelGeometry : public testing::TestWithParam<Shape> {
protected:
  Scene scene = flow_scene(GetParam().overrides);
  ChannelShape shape = channel_shape(scene.geometry);
};

TEST_P(ChannelGeometry, IsClosedButForInletAndOutlet) {
  for (const auto& [edge, count] : open_edges(channel_walls(scene.geometry))) {
    const double xa = static_cast<double>(std::get<0>(edge.first)) * 1e-9;
    const double xb = static_cast<double>(std::get<0>(edge.second)) * 1e-9;
    EXPECT_EQ(count, 1);
    EXPECT_NEAR(xa, xb, 1e-9);
    const bool at_opening =
        std::abs(xa - channel_start(scene.geometry)) < 2e-9 || std::abs(xa - channel_end(scene.geometry)) < 2e-9;
    EXPECT_TRUE(at_opening) << "a hole at x = " << xa;
  }
}

TEST_P(ChannelGeometry, NormalsPointIntoTheFluid) {
  for (const Triangle& t : channel_walls(scene.geometry)) {
    const Vec3 area = area_vector(t);
    ASSERT_GT(area.norm(), 0);
    const Vec3 inside = (t.corner[0] + t.corner[1] + t.corner[2]) / 3 + 1e-7 * area.normalized();
    EXPECT_GT(inside.z, 0);
    EXPECT_LT(inside.z, scene.geometry.neck_height);
    EXPECT_LT(inside.y, shape.upper.distance(inside.x));
    EXPECT_GT(inside.y, -shape.lower.distance(inside.x));
  }
}

// Gauss: the openings and the walls bound the channel, so sum of x.A gives three volumes.
TEST_P(ChannelGeometry, EnclosesTheVolumeOfTheChannel) {
  const double height = scene.geometry.neck_height, end = channel_end(scene.geometry);
  double sum = 0;
  for (const Triangle& t : channel_walls(scene.geometry)) sum -= dot(t.corner[0], area_vector(t)) / 3;
  sum += end * shape.width(end) * height / 3;
  sum -= channel_start(scene.geometry) * scene.geometry.channel_width * height / 3;
  const double volume = channel_volume(scene.geometry, channel_start(scene.geometry), end);
  // The flat pieces of an arc cut off a little of the fluid's corner.
  EXPECT_NEAR(sum / volume, 1, scene.geometry.neck_rounding > 0 ? 2e-5 : 1e-12);
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, ChannelGeometry,
    testing::Values(Shape{"gentle", {"geometry.half_angle=10 deg"}}, Shape{"paper", {}},
                    Shape{"step", {"geometry.half_angle=90 deg"}}, Shape{"duct", {"geometry.channel_width=100 um"}},
                    Shape{"rounded", {"geometry.neck_rounding=50 um"}},
                    Shape{"rounded_step", {"geometry.half_angle=90 deg", "geometry.neck_rounding=50 um"}},
                    Shape{"expansion", {"geometry.expansion_width=300 um"}},
                    Shape{"sudden_expansion", {"geometry.expansion_width=500 um", "geometry.expansion_angle=90 deg"}},
                    Shape{"two_steps", {"geometry.step_width=200 um", "geometry.step_length=150 um"}},
                    Shape{"asymmetric", {"geometry.half_angle_below=30 deg", "geometry.neck_rounding=20 um"}},
                    Shape{"one_sided_step", {"geometry.half_angle=90 deg", "geometry.half_angle_below=20 deg"}}),
    [](const auto& info) { return info.param.name; });

// R = 0.5 D around (R tan(30 deg), D): from the slanted wall to the neck, tangent to both.
TEST(ChannelShapeByHand, RoundsTheNeck) {
  const Scene scene = flow_scene({"geometry.neck_rounding=50 um"});
  const double t = 0.5e-4 * 0.57735027;
  EXPECT_NEAR(neck_start(scene.geometry), t, 1e-12);
  EXPECT_NEAR(channel_shape(scene.geometry).width(t), 1e-4, 1e-12);
  // At x = 0: 2 (D - sqrt(R^2 - t^2)) = 2 D (1 - 0.5 sqrt(2/3))
  EXPECT_NEAR(channel_shape(scene.geometry).width(0), 2e-4 * (1 - 0.5 * 0.81649658), 1e-12);
  // The arc begins at -t cos(60 deg) on the slanted wall.
  EXPECT_NEAR(channel_shape(scene.geometry).width(-t / 2), 1e-4 + t * 1.7320508, 1e-11);
}

TEST(ChannelShapeByHand, WidensAfterTheNeck) {
  const Scene scene = flow_scene({"geometry.expansion_width=300 um", "geometry.expansion_angle=45 deg"});
  EXPECT_NEAR(channel_end(scene.geometry), 1e-4 + 1e-4 + 3e-4, 1e-12);
  EXPECT_NEAR(channel_shape(scene.geometry).width(1.5e-4), 2e-4, 1e-12);
}

TEST(ChannelShapeByHand, NarrowsTwice) {
  const Scene scene = flow_scene({"geometry.step_width=200 um", "geometry.step_length=150 um"});
  // 1.5 D / tan(60 deg) + 1.5 D
  EXPECT_NEAR(narrowing_length(scene.geometry), 0.8660254e-4 + 1.5e-4, 1e-11);
  EXPECT_NEAR(channel_shape(scene.geometry).width(-1e-4), 2e-4, 1e-15);
}

TEST(Triangulation, RefusesALoopThatCrossesItself) {
  EXPECT_THAT(refusal([] { triangulate({{0, 0}, {1, 1}, {1, 0}, {0, 1}}); }), testing::HasSubstr("crosses itself"));
}

// D = 1e-4 m: 4 D x 10 D before the narrowing of 1.5 D / tan 60, slanted walls of 1.5 D / sin 60.
TEST(ChannelGeometryAreas, AreThoseByHand) {
  double slanted = 0, floor = 0, side = 0;
  for (const Triangle& t : channel_walls(flow_scene().geometry)) {
    const Vec3 area = area_vector(t);
    const Vec3 n = area.normalized();
    if (n.z > 0.5) floor += area.norm();
    if (std::abs(n.y) > 0.9) side += area.norm();
    if (std::abs(n.x) > 0.1) {
      slanted += area.norm();
      EXPECT_NEAR(n.x, -std::sin(std::numbers::pi / 3), 1e-12);
    }
  }
  EXPECT_NEAR(slanted, 2 * 1.7320508e-8, 1e-15);
  EXPECT_NEAR(side, 2 * (10 + 1) * 1e-8, 1e-15);
  EXPECT_NEAR(floor, (40 + 2.5 * 0.8660254 + 1) * 1e-8, 1e-14);
}

}  // namespace
}  // namespace clogflow
