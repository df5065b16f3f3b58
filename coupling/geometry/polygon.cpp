#include "coupling/geometry/polygon.hpp"

#include <algorithm>
#include <numeric>

#include "coupling/base/require.hpp"

namespace clogflow {
namespace {

using Vec2 = Eigen::Vector2d;

// Twice the area of a triangle, > 0 when counter-clockwise.
double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

// Height over the longest edge relative to it: 0 for a degenerate triangle.
double fatness(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return turn(a, b, c) / longest;
}

// Rounding of coordinates, relative to the triangle.
constexpr double flat = 1e-9;

// In the triangle or on its border.
bool covers(const std::array<Vec2, 3>& t, const Vec2& p) {
  const double least = -flat * turn(t[0], t[1], t[2]);
  return turn(t[0], t[1], p) >= least && turn(t[1], t[2], p) >= least && turn(t[2], t[0], p) >= least;
}

}  // namespace

std::vector<std::array<int, 3>> triangulate(const std::vector<Vec2>& corners) {
  std::vector<int> left(corners.size());
  std::iota(left.begin(), left.end(), 0);
  std::vector<std::array<int, 3>> triangles;
  while (left.size() > 2) {
    const std::size_t n = left.size();
    std::size_t best = n;
    double fattest = flat;
    for (std::size_t i = 0; i < n; ++i) {
      const std::array<int, 3> at{left[(i + n - 1) % n], left[i], left[(i + 1) % n]};
      const std::array<Vec2, 3> ear{corners[at[0]], corners[at[1]], corners[at[2]]};
      const double fat = fatness(ear[0], ear[1], ear[2]);
      if (fat <= fattest || std::ranges::any_of(left, [&](int other) {
            return std::ranges::find(at, other) == at.end() && covers(ear, corners[other]);
          }))
        continue;
      best = i;
      fattest = fat;
    }
    require(best < n, "the outline of the channel crosses itself (an impossible shape)");
    triangles.push_back({left[(best + n - 1) % n], left[best], left[(best + 1) % n]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
  }
  return triangles;
}

}  // namespace clogflow
