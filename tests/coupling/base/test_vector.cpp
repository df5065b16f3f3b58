// The vector of three numbers, against values computed by hand.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "coupling/base/vector.hpp"

namespace clogflow {
namespace {

TEST(Vector, products_and_lengths_are_those_by_hand) {
  const Vec3 a(1, 2, -2), b(3, 0, 4);
  EXPECT_EQ(dot(a, b), -5);
  EXPECT_EQ(cross(a, b), Vec3(8, -10, -6));
  EXPECT_EQ(dot(cross(a, b), a), 0);
  EXPECT_EQ(a.squaredNorm(), 9);
  EXPECT_EQ(b.norm(), 5);
  EXPECT_EQ(b.normalized(), Vec3(0.6, 0, 0.8));
  EXPECT_EQ(Vec3::Zero().normalized(), Vec3::Zero());
}

TEST(Vector, components_go_one_by_one) {
  const Vec3 a(1, -2, 3), b(0, 5, -7);
  EXPECT_EQ(a.cwiseMin(b), Vec3(0, -2, -7));
  EXPECT_EQ(a.cwiseMax(b), Vec3(1, 5, 3));
  EXPECT_EQ(b.cwiseAbs(), Vec3(0, 5, 7));
  EXPECT_EQ(b.minCoeff(), -7);
  EXPECT_EQ(b.maxCoeff(), 5);
  EXPECT_EQ(2 * a - b / 2, Vec3(2, -6.5, 9.5));
  Vec3 c = a;
  c += b, c *= 2, c[1] = 8;
  EXPECT_EQ(c, Vec3(2, 8, -8));
  for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(c.array()[axis], c[axis]);
}

TEST(Vector, what_is_no_number_is_within_nothing) {
  const Vec3 low(0, 0, 0), high(1, 1, 1);
  EXPECT_TRUE(Vec3(0, 0.5, 1).within(low, high));
  EXPECT_FALSE(Vec3(0, 0.5, 1.1).within(low, high));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 place(0.5, 0.5, 0.5);
    EXPECT_TRUE(place.allFinite());
    place[axis] = nan;
    EXPECT_FALSE(place.within(low, high));
    EXPECT_FALSE(place.allFinite());
  }
}

}  // namespace
}  // namespace clogflow
