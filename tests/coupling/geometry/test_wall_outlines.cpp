// Cuts of walls: whole lines, openings side by side, obstacles, and which opening a place belongs to.
#include "coupling/geometry/wall_outlines.hpp"

#include <gtest/gtest.h>

#include "coupling/base/source_folder.hpp"
#include "coupling/geometry/stl_channel.hpp"

namespace clogflow {
namespace {

using Vec2 = Eigen::Vector2d;

Geometry shape(const char* file) {
  Geometry g;
  g.present = true, g.stl = (source_folder() / "scenes" / file).string(), g.stl_unit = 1e-6;
  return g;
}

/// Walls parallel to x from 0 to 1 over a closed line in (y, z), the fluid on its left.
void add_tube(Walls& walls, const std::vector<Vec2>& corners) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const Vec3 a0(0, a.x(), a.y()), b0(0, b.x(), b.y()), a1(1, a.x(), a.y()), b1(1, b.x(), b.y());
    walls.push_back({{a0, b1, b0}});
    walls.push_back({{a0, a1, b1}});
  }
}

std::vector<Vec2> square(double y, double z, double side) {
  return {{y, z}, {y + side, z}, {y + side, z + side}, {y, z + side}};
}

std::vector<Vec2> turned(std::vector<Vec2> corners) { return {corners.rbegin(), corners.rend()}; }

TEST(WallOutlines, AnObstacleMakesNoOtherOpeningAndTwoTubesDo) {
  Walls walls;
  add_tube(walls, square(5, 0, 2));
  add_tube(walls, square(0, 0, 3));
  add_tube(walls, turned(square(1, 1, 1)));
  const auto lines = cut_across(walls, 0.5);
  ASSERT_EQ(lines.size(), 3u);
  for (const WallOutline& line : lines) EXPECT_TRUE(line.closed);
  const auto openings = openings_at(walls, 0.5);
  ASSERT_EQ(openings.size(), 2u);
  // In order of y.
  EXPECT_NEAR(openings[0].area(), 9, 1e-12);
  EXPECT_NEAR(openings[1].area(), 4, 1e-12);
  EXPECT_EQ(opening_of(openings, {0.5, 2.5}), 0);
  EXPECT_EQ(opening_of(openings, {6, 1}), 1);
  // In the wall between them: the nearer one, 0.9 and 1.1 from the sides.
  EXPECT_EQ(opening_of(openings, {3.9, 1}), 0);
  EXPECT_EQ(opening_of(openings, {4.1, 1}), 1);
}

TEST(WallOutlines, TwoNecksAreFoundInTheFile) {
  const auto channel = read_stl_channel(shape("two_necks.stl"));
  EXPECT_EQ(openings_at(channel->walls, -300e-6).size(), 1u);
  const auto necks = openings_at(channel->walls, 50e-6);
  ASSERT_EQ(necks.size(), 2u);
  for (const WallOutline& neck : necks) EXPECT_NEAR(neck.area() / 1e-8, 1, 1e-9);
  EXPECT_EQ(opening_of(necks, {-75e-6, 50e-6}), 0);
  EXPECT_EQ(opening_of(necks, {75e-6, 50e-6}), 1);
  EXPECT_NEAR(channel->neck_width, 100e-6, 1e-12);
  EXPECT_NEAR(channel->neck_area, 2e-8, 1e-14);
  EXPECT_EQ(channel->round.diameter, 0);
}

TEST(WallOutlines, APipeIsRoundAndHasOneNeck) {
  const auto channel = read_stl_channel(shape("pipe.stl"));
  // 48 sides of a circle of 150 um: R cos(pi/48), and 48/2 R^2 sin(2 pi/48).
  EXPECT_NEAR(channel->round.diameter / (300e-6 * std::cos(M_PI / 48)), 1, 1e-5);
  EXPECT_NEAR(channel->round.area / (24 * 150e-6 * 150e-6 * std::sin(M_PI / 24)), 1, 1e-5);
  EXPECT_NEAR(channel->neck_area / (24 * 50e-6 * 50e-6 * std::sin(M_PI / 24)), 1, 1e-3);
  EXPECT_EQ(openings_at(channel->walls, 50e-6).size(), 1u);
}

TEST(WallOutlines, TheFluidInThePlaneOfAPictureIsClosed) {
  for (const auto& [file, area] :
       {std::pair("two_necks.stl", 500 * 400 + 60 * 400 - 75 * 60 - 25 * 60 + 2 * 100 * 100), {"pore.stl", 0}}) {
    const auto channel = read_stl_channel(shape(file));
    const auto cut = cut_along(channel->walls, 49.99e-6);
    EXPECT_EQ(cut.size(), area > 0 ? 3u : 2u) << file;
    const auto loops = closed_outlines(cut);
    ASSERT_EQ(loops.size(), 1u) << file;
    if (area > 0) {
      EXPECT_NEAR(loops[0].area() / (area * 1e-12), 1, 1e-9) << file;
    }
    EXPECT_TRUE(loops[0].holds({-200e-6, 0}));
    EXPECT_EQ(loops[0].holds({50e-6, 0}), std::string(file) == "pore.stl");
  }
}

}  // namespace
}  // namespace clogflow
