// The undisturbed fluid velocity V0 at a place.
#pragma once

#include <array>
#include <vector>

#include "coupling/files/flow_grid.hpp"
#include "coupling/scene/scene.hpp"
#include "dem/kernels/kernels.hpp"

namespace clogflow {

/// V0 from the grid, by the nearest point as in the paper or trilinear; or the same everywhere. The
/// grid is shared between runs: the field is read only. Outside the grid its nearest face counts.
class FlowField {
public:
  /// No fluid moves.
  FlowField() = default;
  explicit FlowField(const std::array<double, 3>& uniform) : uniform_(uniform) {}
  FlowField(const FlowGrid& grid, Lookup lookup);

  /// V0 [m/s]
  std::array<double, 3> at(double x, double y, double z) const;

  /// Fills in the grid for the lookup of many places at once.
  /// \return whether there is one: a grid that is read by its nearest point
  bool set_nearest(FlowTask& task) const;

  /// Half the curl of V0, the spin of a lone sphere carried along, by central differences over one
  /// spacing [rad/s]
  std::array<double, 3> half_vorticity(double x, double y, double z) const;

  /// Largest speed in the field [m/s]
  double largest_speed() const { return largest_speed_; }

private:
  std::array<double, 3> nearest(const Vec3& place) const;
  std::array<double, 3> trilinear(const Vec3& place) const;
  const float* point(int i, int j, int k) const { return field_ + 3 * grid_->index(i, j, k); }

  const FlowGrid* grid_ = nullptr;
  const float* field_ = nullptr;  // of the grid
  Lookup lookup_ = Lookup::nearest;
  std::array<double, 3> uniform_{};
  double largest_speed_ = 0;
};

}  // namespace clogflow
