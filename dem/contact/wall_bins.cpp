#include "dem/contact/wall_bins.hpp"

#include <algorithm>
#include <cmath>

#include "dem/kernels/grid_place.hpp"

namespace clogflow {

namespace {

constexpr double most_bins_per_axis = 100;

}  // namespace

WallBins::WallBins(const Walls& walls, double reach) {
  if (walls.empty()) return;
  Vec3 high = Vec3::Constant(-1e300);
  low_ = Vec3::Constant(1e300);
  for (const Triangle& t : walls)
    for (const Vec3& corner : t.corner) low_ = low_.cwiseMin(corner), high = high.cwiseMax(corner);
  low_ -= Vec3::Constant(reach);
  high += Vec3::Constant(reach);
  edge_ = std::max(2 * reach, (high - low_).maxCoeff() / most_bins_per_axis);
  for (int a = 0; a < 3; ++a) count_[a] = static_cast<int>((high[a] - low_[a]) / edge_) + 1;
  bins_.assign(static_cast<std::size_t>(count_[0]) * count_[1] * count_[2], {});
  for (int k = 0; k < static_cast<int>(walls.size()); ++k) {
    const auto& corner = walls[k].corner;
    const Vec3 least = corner[0].cwiseMin(corner[1]).cwiseMin(corner[2]);
    const Vec3 most = corner[0].cwiseMax(corner[1]).cwiseMax(corner[2]);
    const auto from = cell_of(least - Vec3::Constant(reach));
    const auto to = cell_of(most + Vec3::Constant(reach));
    for (int x = from[0]; x <= to[0]; ++x)
      for (int y = from[1]; y <= to[1]; ++y)
        for (int z = from[2]; z <= to[2]; ++z) bins_[index({x, y, z})].push_back(k);
  }
}

std::array<int, 3> WallBins::cell_of(const Vec3& place) const {
  std::array<int, 3> cell{};
  for (int a = 0; a < 3; ++a) cell[a] = cell_number((place[a] - low_[a]) / edge_, count_[a]);
  return cell;
}

const std::vector<int>& WallBins::near(const Vec3& place) const { return bins_[index(cell_of(place))]; }

}  // namespace clogflow
