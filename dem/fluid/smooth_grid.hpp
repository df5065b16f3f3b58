// Amounts at places, smoothed by a Gaussian on the points of a regular grid.
#pragma once

#include <array>
#include <vector>

#include "coupling/base/vector.hpp"
#include "dem/physics/number.hpp"

namespace clogflow {

/// Points from one corner of a box to the other, half a width of the kernel apart or a little less. An amount is shared
/// out among the eight points around it, and read between them, by distance: both are continuous, so a particle that
/// sits between two cells cannot make a field flip. Each widens the kernel by the variance h^2 / 6 (on average over the
/// places in a cell), which the smoothing between them leaves out.
class SmoothGrid {
public:
  SmoothGrid() = default;

  /// \param width  standard deviation of the whole kernel [m]; it is cut at three of them, without 0.3 % of its weight
  /// in
  ///               each direction
  /// \throws Error if there would be too many points
  SmoothGrid(const Vec3& low, const Vec3& high, double width);

  std::size_t size() const { return stride_[3]; }
  const Vec3& low() const { return low_; }
  int cells(int axis) const { return cells_[axis]; }
  double spacing(int axis) const { return 1 / per_length_[axis]; }

  /// Values at the points, x fastest; as V0 in single precision, which makes the smoothing twice as fast.
  using Values = std::vector<float>;

  /// Beyond the box its nearest face counts.
  void add(Values& values, const Vec3& place, double amount) const;
  double read(const Values& values, const Vec3& place) const;

  /// Nothing comes in from beyond the box.
  void smooth(Values& values) const;

private:
  struct Cell {
    std::size_t corner;
    double share[3];  // of the farther points
  };
  Cell cell_of(const Vec3& place) const;
  void smooth_along(int axis, const Values& from, Values& to) const;

  Vec3 low_ = Vec3::Zero();
  std::array<int, 3> cells_{};
  std::array<double, 3> per_length_{};     // [1/m]
  std::array<std::size_t, 4> stride_{};    // of the points along x, y and z; then the number of all
  std::array<std::vector<float>, 3> tap_;  // of the point itself, the next, ...
};

}  // namespace clogflow
