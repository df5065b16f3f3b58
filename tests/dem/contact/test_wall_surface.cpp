// Where a sphere touches a surface of triangles: faces, edges and corners, each counted once.
#include <algorithm>
#include <numeric>

#include <gmock/gmock.h>

#include "coupling/geometry/wall_mesh.hpp"
#include "dem/contact/closest_point.hpp"
#include "dem/contact/wall_surface.hpp"
#include "tests/coupling/refusal.hpp"
#include "tests/dem/contact/wall_shapes.hpp"

namespace clogflow::test {
namespace {

std::vector<WallPoint> contacts(const WallSurface& surface, const Vec3& centre, double radius) {
  std::vector<int> all(surface.size());
  std::iota(all.begin(), all.end(), 0);
  std::vector<WallPoint> found;
  surface.closest_points(all, centre, radius, found);
  return found;
}

std::vector<WallPoint> contacts(const Walls& walls, const Vec3& centre, double radius) {
  return contacts(WallSurface(walls), centre, radius);
}

TEST(ClosestPoint, OfEachPartOfATriangle) {
  const Triangle t{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}};
  const auto expect = [&](const Vec3& centre, const Vec3& point, int corners) {
    const ClosestPoint found = closest_point(t, centre);
    EXPECT_LT((found.point - point).norm(), 1e-15);
    EXPECT_EQ(found.corners, corners);
  };
  expect({0.2, 0.3, 0.7}, {0.2, 0.3, 0}, 3);
  expect({0.5, -1, 0.7}, {0.5, 0, 0}, 2);
  expect({-1, 0.25, 0}, {0, 0.25, 0}, 2);
  expect({1, 1, -2}, {0.5, 0.5, 0}, 2);
  expect({-1, -2, 3}, {0, 0, 0}, 1);
  expect({3, -1, 1}, {1, 0, 0}, 1);
  expect({-1, 3, 1}, {0, 1, 0}, 1);
}

TEST(WallSurface, FaceCountsOnceOnTheDiagonalOfItsTriangles) {
  for (const Vec3& foot : {Vec3(0.3, -0.2, 0), Vec3(0.3, 0.3, 0), Vec3(0, 0, 0)}) {
    const auto found = contacts(floor_plate(1), foot + Vec3(0, 0, 0.09), 0.1);
    ASSERT_EQ(found.size(), 1u) << foot.x << " " << foot.y << " " << foot.z;
    EXPECT_LT((found[0].point - foot).norm(), 1e-15);
    EXPECT_NEAR(found[0].distance, 0.09, 1e-15);
    EXPECT_NEAR(found[0].normal.z, 1, 1e-15);
  }
}

TEST(WallSurface, ConvexEdgeCountsOnce) {
  const Walls wedge = bent_plate(-M_PI / 3, 1);
  // Above the edge, between the two planes' normals: only the edge is met.
  const Vec3 up(std::sin(M_PI / 6), 0, std::cos(M_PI / 6));
  const auto found = contacts(wedge, 0.09 * up + Vec3(0, 0.2, 0), 0.1);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_LT((found[0].point - Vec3(0, 0.2, 0)).norm(), 1e-15);
  EXPECT_LT((found[0].normal - up).norm(), 1e-14);
}

TEST(WallSurface, BesideAConvexEdgeOnlyTheFaceIsMet) {
  const auto found = contacts(bent_plate(-M_PI / 3, 1), {-0.01, 0.2, 0.09}, 0.1);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_LT((found[0].normal - Vec3(0, 0, 1)).norm(), 1e-14);
}

TEST(WallSurface, ReentrantCornerMeetsBothFacesAndNotTheEdge) {
  const auto found = contacts(bent_plate(M_PI / 3, 1), {-0.05, 0.2, 0.09}, 0.1);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(std::min(found[0].distance, found[1].distance), 0.05 * std::sin(M_PI / 3) + 0.045, 1e-15);
  EXPECT_NEAR(std::max(found[0].distance, found[1].distance), 0.09, 1e-15);
}

TEST(WallSurface, TipOfAPyramidCountsOnce) {
  Walls pyramid;
  const Vec3 tip(0, 0, 0);
  const std::array<Vec3, 4> base{Vec3(1, 1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, -1), Vec3(1, -1, -1)};
  for (int k = 0; k < 4; ++k) pyramid.push_back({{tip, base[k], base[(k + 1) % 4]}});
  const auto found = contacts(pyramid, {0.001, -0.002, 0.09}, 0.1);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].point.norm(), 0);
}

TEST(WallSurface, NothingIsMetOutOfReach) { EXPECT_TRUE(contacts(floor_plate(1), {0, 0, 0.1000001}, 0.1).empty()); }

/// The contacts in an order that does not depend on the triangles'.
std::vector<WallPoint> sorted(std::vector<WallPoint> points) {
  std::ranges::sort(points, {}, [](const WallPoint& w) { return w.distance; });
  return points;
}

void expect_same_contacts(const WallSurface& coarse, const WallSurface& fine, const Vec3& centre) {
  const auto a = sorted(contacts(coarse, centre, 0.1)), b = sorted(contacts(fine, centre, 0.1));
  ASSERT_EQ(a.size(), b.size()) << centre.x << " " << centre.y << " " << centre.z;
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_NEAR(a[k].distance, b[k].distance, 1e-14);
    EXPECT_LT((a[k].point - b[k].point).norm(), 1e-12) << centre.x << " " << centre.y << " " << centre.z;
  }
}

/// The same contacts over a bent plate and over the same plate cut, at 2000 random places for each angle.
template <class Cut>
void expect_same_when_cut(unsigned seed, const Cut& cut) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> across(-0.3, 0.3), height(0.02, 0.12);
  for (const double angle : {-M_PI / 3, 0.0, M_PI / 3, -M_PI / 2}) {
    const Walls coarse = bent_plate(angle, 1);
    const WallSurface whole(coarse), fine(cut(coarse, random));
    for (int k = 0; k < 2000; ++k) {
      const double x = across(random);
      // Above the surface on both sides of the bend; not closer than rounding to both planes.
      const double ground = x > 0 && angle > -1.5 ? x * std::tan(angle) : 0;
      expect_same_contacts(whole, fine, {x, across(random), ground + height(random)});
    }
  }
}

TEST(WallSurface, ResultDoesNotDependOnTheTriangulation) {
  expect_same_when_cut(7, [](const Walls& walls, std::mt19937& random) {
    return cut_in_three(cut_in_four(cut_in_four(walls)), random);
  });
}

/// Every second triangle cut, its neighbours not: corners hang on the edges of those.
Walls cut_here_and_there(const Walls& walls, std::mt19937& random) {
  Walls finer;
  for (const Triangle& t : walls) {
    const Walls parts = random() % 2 ? cut_in_four({t}) : Walls{t};
    finer.insert(finer.end(), parts.begin(), parts.end());
  }
  return finer;
}

TEST(WallSurface, ResultDoesNotDependOnHangingCorners) {
  expect_same_when_cut(3, [](const Walls& walls, std::mt19937& random) {
    return cut_here_and_there(cut_here_and_there(cut_in_four(cut_in_four(walls)), random), random);
  });
}

TEST(WallSurface, AHangingCornerCutsTheTriangleItHangsOn) {
  // Two small squares beside a large one: their common corner lies on its edge.
  Walls walls;
  add_quad(walls, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  add_quad(walls, {1, 0, 0}, {2, 0, 0}, {2, 0.5, 0}, {1, 0.5, 0});
  add_quad(walls, {1, 0.5, 0}, {2, 0.5, 0}, {2, 1, 0}, {1, 1, 0});
  const WallSurface surface(walls);
  EXPECT_EQ(surface.size(), 7u);
  EXPECT_EQ(surface.patches().size(), 1u);
  double area = 0;
  for (const Triangle& t : surface.triangles())
    area += cross(t.corner[1] - t.corner[0], t.corner[2] - t.corner[0]).z / 2;
  EXPECT_NEAR(area, 2, 1e-15);
}

TEST(WallSurface, ATriangleThatComesTwiceCountsOnce) {
  Walls walls = floor_plate(1);
  const auto [a, b, c] = walls[0].corner;
  walls.push_back({{c, a, b}});
  walls.push_back({{b, a, c}});  // seen from the other side
  EXPECT_EQ(WallSurface(walls).size(), 2u);
  EXPECT_EQ(contacts(walls, {0.3, -0.2, 0.09}, 0.1).size(), 1u);
  const LeftOut left_out = join_corners(walls, 1e-6).left_out;
  EXPECT_EQ(left_out.words(), "2 facets with the corners of another (number 3 the first) are left out");
}

/// A corner hangs on the middle of an edge, and within the tolerance beside it.
TEST(WallSurface, AHangingCornerMayLieBesideTheEdge) {
  for (const double beside : {0.0, 5e-7, -5e-7, 3e-6}) {
    Walls walls;
    add_quad(walls, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
    add_quad(walls, {1, 0, 0}, {2, 0, 0}, {2, 0.5, 0}, {1 + beside, 0.5, 0});
    add_quad(walls, {1 + beside, 0.5, 0}, {2, 0.5, 0}, {2, 1, 0}, {1, 1, 0});
    // Its outline; where it is too far from the edge, that edge is open too, on both sides.
    EXPECT_NEAR(open_rims(join_walls(walls))[0].length, std::abs(beside) < 2e-6 ? 6 : 8, 1e-4) << beside;
  }
}

/// Many corners on one edge, each side of a triangle with some, in any order.
TEST(WallSurface, ManyHangingCornersCutATriangleOnceEach) {
  std::mt19937 random(5);
  const std::array<Vec3, 3> tip{Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(1, 2, 0)};
  for (int count = 1; count < 12; ++count) {
    Walls walls{{{tip[0], tip[1], tip[2]}}};
    int hanging = 0;
    for (int k = 0; k < 3; ++k) {
      const Vec3 from = tip[(k + 1) % 3], to = tip[k];
      const Vec3 middle = (tip[0] + tip[1] + tip[2]) / 3, out = from + to - middle;
      const int pieces = 1 + static_cast<int>(random() % static_cast<unsigned>(count));
      for (int i = 0; i < pieces; ++i)
        walls.push_back({{from + (to - from) * i / pieces, from + (to - from) * (i + 1) / pieces, out}});
      hanging += pieces - 1;
    }
    std::shuffle(walls.begin(), walls.end(), random);
    const WallMesh mesh = join_walls(walls);
    EXPECT_EQ(mesh.triangles.size(), walls.size() + hanging);
    EXPECT_EQ(open_rims(mesh).size(), 1u);
    double area = 0, before = 0;
    for (const Triangle& t : mesh.triangles) area += cross(t.corner[1] - t.corner[0], t.corner[2] - t.corner[0]).z / 2;
    for (const Triangle& t : walls) before += cross(t.corner[1] - t.corner[0], t.corner[2] - t.corner[0]).z / 2;
    EXPECT_NEAR(area, before, 1e-12);
  }
}

TEST(WallSurface, WeldingGoesOnFromCornerToCorner) {
  // Five corners of one place in a row, each 0.9 tolerances from the next in x: the ends are one only through the
  // others.
  const double tolerance = 1e-3, step = 0.9e-3;
  std::vector<int> order{0, 1, 2, 3};
  do {
    Walls walls;
    for (const int k : order) walls.push_back({{Vec3(k * step, 0, 0), Vec3(1, k, 0), Vec3(1, k + 1, 0)}});
    const WeldedCorners welded = weld_corners(walls, tolerance);
    EXPECT_EQ(welded.place.size(), 6u);
    for (const auto& corner : welded.corner) EXPECT_EQ(corner[0], 0);
    EXPECT_EQ(welded.place[0], walls[0].corner[0]);
  } while (std::next_permutation(order.begin(), order.end()));
  // A longer row is a shape, not a seam.
  Walls walls;
  for (int k = 0; k < 8; ++k) walls.push_back({{Vec3(k * step, 0, 0), Vec3(1, k, 0), Vec3(1, k + 1, 0)}});
  EXPECT_THAT(refusal([&] { weld_corners(walls, tolerance); }), testing::HasSubstr("larger than the facets there"));
  EXPECT_EQ(weld_corners(walls, 0.8e-3).place.size(), 17u);
}

TEST(WallSurface, AToleranceFindsWhatItIsGiven) {
  // Pairs of corners in any direction and place: one if no coordinate differs by more.
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(-1, 1), share(-1.5, 1.5);
  for (int k = 0; k < 2000; ++k) {
    const Vec3 a(place(random), place(random), place(random));
    const Vec3 apart = 1e-6 * Vec3(share(random), share(random), share(random));
    const Walls walls{{{a, Vec3(2, 0, 0), Vec3(0, 2, 0)}}, {{a + apart, Vec3(0, 2, 0), Vec3(-2, 0, 3)}}};
    EXPECT_EQ(weld_corners(walls, 1e-6).place.size(), apart.cwiseAbs().maxCoeff() <= 1e-6 ? 4u : 5u);
  }
}

TEST(WallSurface, FindsWhereItIsOpen) {
  EXPECT_EQ(open_rims(join_walls(floor_plate(1))).size(), 1u);
  EXPECT_DOUBLE_EQ(open_rims(join_walls(floor_plate(1)))[0].length, 8);
  Walls tube;
  const std::array<Vec3, 4> turn{Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(0, 1, 1), Vec3(0, 0, 1)};
  const Vec3 along(3, 0, 0);
  for (int k = 0; k < 4; ++k) add_quad(tube, turn[k], turn[(k + 1) % 4], turn[(k + 1) % 4] + along, turn[k] + along);
  EXPECT_EQ(open_rims(join_walls(tube)).size(), 2u);
  EXPECT_EQ(open_rims(join_walls(cut_in_four(tube))).size(), 2u);
  add_quad(tube, turn[0], turn[3], turn[2], turn[1]);
  Walls box = tube;
  add_quad(box, turn[0] + along, turn[1] + along, turn[2] + along, turn[3] + along);
  EXPECT_TRUE(open_rims(join_walls(box)).empty());
  // A facet is missing in the upper side, away from the end: a hole of its own, the shorter one.
  Walls holed = cut_in_four(cut_in_four(tube));
  const Triangle gone = cut_in_four(cut_in_four({tube[4]}))[15];
  std::erase_if(holed, [&](const Triangle& t) { return t.corner == gone.corner; });
  const auto rims = open_rims(join_walls(holed));
  ASSERT_EQ(rims.size(), 2u);
  const auto& [a, b, c] = gone.corner;
  EXPECT_DOUBLE_EQ(rims[0].length, (b - a).norm() + (c - b).norm() + (a - c).norm());
  EXPECT_DOUBLE_EQ(rims[1].length, 4);
}

TEST(WallSurface, FindsFlatPatches) {
  EXPECT_EQ(WallSurface(cut_in_four(floor_plate(1))).patches().size(), 1u);
  EXPECT_EQ(WallSurface(bent_plate(0.5, 1)).patches().size(), 2u);
}

TEST(WallSurface, AFacetWithoutAreaIsLeftOut) {
  Walls walls = floor_plate(1);
  walls.push_back({{Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(2, 2, 2)}});
  EXPECT_EQ(WallSurface(walls).size(), 2u);
  EXPECT_EQ(join_corners(walls, 1e-6).left_out.words(), "1 facet without area (number 3) is left out");
}

}  // namespace
}  // namespace clogflow::test
