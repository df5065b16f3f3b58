#include "dem/fluid/smooth_grid.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/base/expect.hpp"
#include "coupling/base/require.hpp"
#include "dem/kernels/grid_place.hpp"
#include "dem/physics/porosity.hpp"

namespace clogflow {

namespace {

constexpr double points_per_width = 2, widths_seen = 3;

/// More than the memory of a core holds some of; a width with a wrong unit gets here.
constexpr double most_points = 3e7;

std::vector<float> taps(double spacing, double width) {
  const double rest = std::sqrt(width * width - spacing * spacing / 3);
  std::vector<double> weights;
  double sum = 0;
  for (int k = 0; k * spacing < widths_seen * width; ++k) {
    weights.push_back(gaussian_kernel(k * spacing, rest));
    sum += (k > 0 ? 2 : 1) * weights.back();
  }
  std::vector<float> shares;
  for (const double weight : weights) shares.push_back(static_cast<float>(weight / sum));
  return shares;
}

}  // namespace

SmoothGrid::SmoothGrid(const Vec3& low, const Vec3& high, double width) : low_(low) {
  double points = 1;
  for (int a = 0; a < 3; ++a) points *= 1 + std::ceil(points_per_width * (high[a] - low[a]) / width);
  require(points < most_points,
          "porosity.width = {} m (its grid would have {:.2g} points in this channel, more than {:.0g}): raise it",
          width, points, most_points);
  stride_[0] = 1;
  for (int a = 0; a < 3; ++a) {
    const double extent = high[a] - low[a];
    expect(extent > 0);
    cells_[a] = static_cast<int>(std::ceil(points_per_width * extent / width));
    per_length_[a] = cells_[a] / extent;
    stride_[a + 1] = stride_[a] * (cells_[a] + 1);
    tap_[a] = taps(spacing(a), width);
  }
}

SmoothGrid::Cell SmoothGrid::cell_of(const Vec3& place) const {
  const double along[3] = {place.x - low_.x, place.y - low_.y, place.z - low_.z};
  Cell cell{};
  for (int a = 0; a < 3; ++a) {
    const double inside = place_within(along[a] * per_length_[a], cells_[a]);
    const int number = std::min(static_cast<int>(inside), cells_[a] - 1);
    cell.corner += number * stride_[a];
    cell.share[a] = inside - number;
  }
  return cell;
}

void SmoothGrid::add(Values& values, const Vec3& place, double amount) const {
  const Cell cell = cell_of(place);
  const double x = cell.share[0], y = cell.share[1], z = cell.share[2];
  float* v = &values[cell.corner];
  const auto along_x = [&](std::size_t at, double part) {
    v[at] += static_cast<float>((1 - x) * part);
    v[at + 1] += static_cast<float>(x * part);
  };
  along_x(0, (1 - y) * (1 - z) * amount);
  along_x(stride_[1], y * (1 - z) * amount);
  along_x(stride_[2], (1 - y) * z * amount);
  along_x(stride_[1] + stride_[2], y * z * amount);
}

double SmoothGrid::read(const Values& values, const Vec3& place) const {
  const Cell cell = cell_of(place);
  const double x = cell.share[0], y = cell.share[1], z = cell.share[2];
  const float* v = &values[cell.corner];
  const auto along_x = [&](std::size_t at) {
    const double here = v[at];
    return here + x * (v[at + 1] - here);
  };
  const auto along_y = [&](std::size_t at) {
    const double here = along_x(at);
    return here + y * (along_x(at + stride_[1]) - here);
  };
  const double here = along_y(0);
  return here + z * (along_y(stride_[2]) - here);
}

void SmoothGrid::smooth_along(int axis, const Values& from, Values& to) const {
  const std::vector<float>& tap = tap_[axis];
  const auto stride = static_cast<std::ptrdiff_t>(stride_[axis]);
  const std::ptrdiff_t count = cells_[axis] + 1, reach = std::min<std::ptrdiff_t>(tap.size(), count) - 1;
  std::ranges::fill(to, 0.0f);
  // Points whose neighbours a shift finds in the same line follow each other in memory, whatever the axis.
  for (std::size_t line = 0; line < size(); line += count * stride)
    for (std::ptrdiff_t shift = -reach; shift <= reach; ++shift) {
      const float weight = tap[std::abs(shift)];
      const std::ptrdiff_t first = std::max<std::ptrdiff_t>(0, -shift) * stride;
      const std::ptrdiff_t number = (count - std::abs(shift)) * stride;
      float* sum = &to[line + first];
      const float* term = &from[line + first + shift * stride];
      for (std::ptrdiff_t k = 0; k < number; ++k) sum[k] += weight * term[k];
    }
}

void SmoothGrid::smooth(Values& values) const {
  Values other(values.size());
  for (int a = 0; a < 3; ++a) {
    smooth_along(a, values, other);
    std::swap(values, other);
  }
}

}  // namespace clogflow
