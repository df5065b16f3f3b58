#include "dem/state/placed_spheres.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/base/expect.hpp"

namespace clogflow {

namespace {

int cell_along(double value, double edge) { return static_cast<int>(std::floor(value / edge)); }

std::int64_t cell_key(int x, int y, int z) {
  constexpr std::int64_t shift = 1 << 20;
  return ((x + shift) << 42) ^ ((y + shift) << 21) ^ (z + shift);
}

}  // namespace

PlacedSpheres::PlacedSpheres(double smallest, double largest) {
  expect(smallest > 0 && smallest <= largest);
  double radius = largest;
  do {
    levels_.push_back({radius, {}});
    radius /= 2;
  } while (radius >= smallest);
}

bool PlacedSpheres::has_room(const Vec3& c, double radius) const {
  for (const Level& level : levels_) {
    const double edge = 2 * level.radius, reach = radius + level.radius;
    int low[3], high[3];
    for (int a = 0; a < 3; ++a) low[a] = cell_along(c[a] - reach, edge), high[a] = cell_along(c[a] + reach, edge);
    for (int x = low[0]; x <= high[0]; ++x)
      for (int y = low[1]; y <= high[1]; ++y)
        for (int z = low[2]; z <= high[2]; ++z) {
          const auto found = level.cells.find(cell_key(x, y, z));
          if (found == level.cells.end()) continue;
          for (const Sphere& other : found->second) {
            const double apart = radius + other.radius;
            if ((other.place - c).squaredNorm() < apart * apart) return false;
          }
        }
  }
  return true;
}

void PlacedSpheres::add(const Vec3& c, double radius) {
  std::size_t level = 0;
  while (level + 1 < levels_.size() && radius <= levels_[level + 1].radius) ++level;
  const double edge = 2 * levels_[level].radius;
  levels_[level].cells[cell_key(cell_along(c.x, edge), cell_along(c.y, edge), cell_along(c.z, edge))].push_back(
      {c, radius});
}

}  // namespace clogflow
