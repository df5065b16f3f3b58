// The undisturbed fluid velocity V0 at a place.
#pragma once

#include <array>
#include <vector>

#include "coupling/flow_grid.hpp"
#include "coupling/scene.hpp"
#include "dem/kernels.hpp"

namespace clog {

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

  /// Fills in the grid for the fast lookup. \return whether it has one: a grid read by its nearest
  /// point
  bool describe(FlowTask& task) const;

  /// Half the curl of V0, the spin of a lone sphere carried along, by central differences over one
  /// spacing [rad/s]
  std::array<double, 3> half_vorticity(double x, double y, double z) const;

  /// Largest speed in the field [m/s]
  double largest_speed() const { return largest_speed_; }

private:
  std::array<double, 3> nearest(const std::array<double, 3>& place) const;
  std::array<double, 3> trilinear(const std::array<double, 3>& place) const;
  const float* point(int i, int j, int k) const {
    return velocity_ + 3 * (i + points_[0] * (j + points_[1] * static_cast<std::ptrdiff_t>(k)));
  }

  const float* velocity_ = nullptr;  // of a grid: x fastest
  std::array<double, 3> origin_{};
  std::array<int, 3> points_{};
  Lookup lookup_ = Lookup::nearest;
  std::array<double, 3> uniform_{};
  double largest_speed_ = 0, spacing_ = 1, per_spacing_ = 1;
};

// Inline: asked for every particle in every step.

inline std::array<double, 3> FlowField::at(double x, double y, double z) const {
  if (!velocity_) return uniform_;
  const std::array<double, 3> place{(x - origin_[0]) * per_spacing_,
                                    (y - origin_[1]) * per_spacing_,
                                    (z - origin_[2]) * per_spacing_};
  return lookup_ == Lookup::nearest ? nearest(place) : trilinear(place);
}

inline std::array<double, 3> FlowField::nearest(const std::array<double, 3>& place) const {
  int at[3];
  for (int a = 0; a < 3; ++a) at[a] = static_cast<int>(nearest_point(place[a], points_[a] - 1.0));
  const float* u = point(at[0], at[1], at[2]);
  return {u[0], u[1], u[2]};
}

}  // namespace clog
