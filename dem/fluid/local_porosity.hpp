// Porosity around each particle: the solid fraction coarse-grained by a Gaussian.
#pragma once

#include <vector>

#include "coupling/geometry/walls.hpp"
#include "dem/fluid/smooth_grid.hpp"
#include "dem/state/particles.hpp"

namespace clogflow {

/// What lies between the walls of a channel.
struct ChannelSpace {
  Walls walls;        ///< open at both ends [m]
  double start, end;  ///< x of the ends [m]
};

/// Equation and source: dem/physics/porosity.hpp. Spheres and the channel's own volume are spread over the same
/// grid in the same way, so their ratio is the fraction of a uniform pack wherever walls and ends are near.
///   eps = 1 - phi, but never below least_porosity
class LocalPorosity {
public:
  /// None.
  LocalPorosity() = default;

  /// \param width  standard deviation of the kernel [m]
  LocalPorosity(const ChannelSpace& space, double width);

  /// Measures anew.
  void update(const Particles& particles);

  double at(const Vec3& place) const { return grid_.read(porosity_, place); }
  bool empty() const { return porosity_.empty(); }

  /// Whether porosities read from a file are those of this grid.
  bool valid() const;

  template <class Archive>
  void exchange(Archive& archive) {
    archive(porosity_);
  }

private:
  SmoothGrid grid_;
  SmoothGrid::Values per_space_;  // over the channel's volume, smoothed; 0 where no part of it is near [1/m3]
  SmoothGrid::Values porosity_;   // at the points [-]
};

}  // namespace clogflow
