// Developed laminar flow in a rectangular duct or a pipe: the inlet profile, and the flow far upstream.
#pragma once

#include "coupling/geometry/geometry.hpp"

namespace clogflow {

/// Velocity over its mean in developed flow through the duct |y| < width/2, 0 < z < height.
///   u = sum over odd n of 4/(pi n^3) sin(n pi z/height) [1 - cosh(n pi y/height) / cosh(n pi
///   width/(2 height))],
/// divided by its own mean; for width < height the two directions change places, so that the sum
/// always runs across the narrow side and converges fast. Zero outside the duct. \source F. M.
/// White, Viscous Fluid Flow, 2nd ed., eq. (3-48)
class DuctFlow {
public:
  /// \param width   along y [m], > 0
  /// \param height  along z [m], > 0
  DuctFlow(double width, double height);

  /// In the wide channel: of its rectangle; in a pipe u/mean = 2 (1 - r^2/R^2), pi R^2 the area of its inlet.
  static DuctFlow of_channel(const Geometry& geometry);

  /// u/mean at a point [-], relative error below 1e-5 of the mean.
  double operator()(double y, double z) const;

  /// Pressure gradient over viscosity and mean velocity [1/m2]; 12/height^2 where the width is infinite, 8/R^2 in a
  /// pipe.
  double resistance() const;

  /// Mean of u/mean over a rectangle inside a rectangular duct [-]: what flows through a mesh face. Exact
  /// integral of the series, so that faces that tile the duct carry exactly the whole flux.
  struct Rectangle {
    double y_min, y_max, z_min, z_max;  ///< [m]
  };
  double mean_over(const Rectangle& rectangle) const;

private:
  double width_, height_;  // of the duct [m]
  bool turned_;            // the series runs across y
  double long_, narrow_;   // sides [m]
  double mean_;            // of the unscaled series [-]
  double radius_ = 0;      // of a pipe [m]; 0: a rectangle
};

}  // namespace clogflow
