#include "dem/fluid/flow_field.hpp"

#include <algorithm>
#include <cmath>

namespace clogflow {

FlowField::FlowField(const FlowGrid& grid, Lookup lookup) : grid_(&grid), field_(grid.field().data()), lookup_(lookup) {
  const std::span<const float> field = grid.field();
  double fastest2 = 0;
  for (std::size_t k = 0; k + 2 < field.size(); k += 3) {
    const double u = field[k], v = field[k + 1], w = field[k + 2];
    fastest2 = std::max(fastest2, u * u + v * v + w * w);
  }
  largest_speed_ = std::sqrt(fastest2);
}

std::array<double, 3> FlowField::at(double x, double y, double z) const {
  if (!grid_) return uniform_;
  const Vec3 place = (Vec3(x, y, z) - grid_->origin) * (1 / grid_->spacing);
  return lookup_ == Lookup::nearest ? nearest(place) : trilinear(place);
}

bool FlowField::set_nearest(FlowTask& task) const {
  if (!grid_ || lookup_ != Lookup::nearest) return false;
  task.velocity = field_;
  task.points_per_length = 1 / grid_->spacing;
  for (int a = 0; a < 3; ++a) task.origin[a] = grid_->origin[a], task.points[a] = grid_->points[a];
  return true;
}

std::array<double, 3> FlowField::nearest(const Vec3& place) const {
  int at[3];
  for (int a = 0; a < 3; ++a) at[a] = static_cast<int>(nearest_point(place[a], grid_->points[a] - 1.0));
  const float* u = point(at[0], at[1], at[2]);
  return {u[0], u[1], u[2]};
}

std::array<double, 3> FlowField::trilinear(const Vec3& place) const {
  int low[3], high[3];
  double share[3];
  for (int a = 0; a < 3; ++a) {
    const double inside = place_within(place[a], grid_->points[a] - 1.0);
    low[a] = static_cast<int>(inside);
    high[a] = std::min(low[a] + 1, grid_->points[a] - 1);
    share[a] = inside - low[a];
  }
  std::array<double, 3> velocity{};
  for (int corner = 0; corner < 8; ++corner) {
    const bool x = corner & 1, y = corner & 2, z = corner & 4;
    const float* u = point(x ? high[0] : low[0], y ? high[1] : low[1], z ? high[2] : low[2]);
    const double weight = (x ? share[0] : 1 - share[0]) * (y ? share[1] : 1 - share[1]) * (z ? share[2] : 1 - share[2]);
    for (int c = 0; c < 3; ++c) velocity[c] += weight * u[c];
  }
  return velocity;
}

std::array<double, 3> FlowField::half_vorticity(double x, double y, double z) const {
  if (!grid_) return {0, 0, 0};
  const double h = grid_->spacing;
  const auto slope = [&](double dx, double dy, double dz) {
    const auto ahead = at(x + dx, y + dy, z + dz), behind = at(x - dx, y - dy, z - dz);
    return std::array<double, 3>{(ahead[0] - behind[0]) / (2 * h), (ahead[1] - behind[1]) / (2 * h),
                                 (ahead[2] - behind[2]) / (2 * h)};
  };
  const auto along_x = slope(h, 0, 0), along_y = slope(0, h, 0), along_z = slope(0, 0, h);
  return {(along_y[2] - along_z[1]) / 2, (along_z[0] - along_x[2]) / 2, (along_x[1] - along_y[0]) / 2};
}

}  // namespace clogflow
