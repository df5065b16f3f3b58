// Where the volume of a sphere counts: cut exactly between two planes, or spread by a kernel.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace clogflow {

/// Volume of the part of a sphere that lies at x < plane.
///   V = pi r^3 (2/3 + t - t^3 / 3),  t = (plane - centre) / r limited to [-1, 1]
/// \param centre  x of the centre [m];  \param radius r [m];  \param plane x of the plane [m]
/// \return [m3]; 0 to 4/3 pi r^3
inline double sphere_volume_below(double centre, double radius, double plane) {
  const double t = std::clamp((plane - centre) / radius, -1.0, 1.0);
  return std::numbers::pi * radius * radius * radius * (2.0 / 3.0 + t - t * t * t / 3.0);
}

inline double sphere_volume(double radius) { return 4.0 / 3.0 * std::numbers::pi * radius * radius * radius; }

/// A sphere's volume spread around its centre, in one direction; in three it is the product of three:
///   W(r) = g(x) g(y) g(z) = exp(-r^2 / (2 s^2)) / (2 pi s^2)^(3/2), integral 1
///   phi(x) = sum_j V_j W(x - x_j) / (integral of W(x - x') over the channel)
/// The division makes a uniform pack uniform up to the walls. Neglected: a sphere counts at its centre, and the kernel
/// sees around corners of the walls.
/// \param distance  x [m];  \param width  s [m] > 0
/// \return g [1/m]
/// \source Goldhirsch, Granular Matter 12 (2010) 239, for fields from kernels;
///         Capecelatro & Desjardins, J. Comput. Phys. 238 (2013) 1, for a Gaussian as the porosity's
inline double gaussian_kernel(double distance, double width) {
  const double share = distance / width;
  return std::exp(-share * share / 2) / (width * std::sqrt(2 * std::numbers::pi));
}

/// What a sphere adds to phi at its own centre, far from walls, [-]:
///   pi/6 d^3 / (2 pi s^2)^(3/2)
inline double own_solid_fraction(double diameter, double width) {
  const double along = diameter * gaussian_kernel(0, width);
  return std::numbers::pi / 6 * along * along * along;
}

}  // namespace clogflow
