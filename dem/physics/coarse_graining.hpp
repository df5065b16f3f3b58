// The kernel that makes a field of single spheres.
#pragma once

#include <cmath>
#include <numbers>

namespace clogflow {

/// A sphere's volume spread around its centre, in one direction; in three it is the product of three:
///   W(r) = g(x) g(y) g(z) = exp(-r^2 / (2 s^2)) / (2 pi s^2)^(3/2),  integral 1, standard deviation s in each
///   direction phi(x) = sum_j V_j W(x - x_j) / (integral of W(x - x') over the channel)
/// The division makes a uniform pack uniform up to the walls. Neglected: a sphere counts at its centre, and the kernel
/// sees around corners of the walls.
/// \param distance  x [m];  \param width  s [m] > 0
/// \return g [1/m]
/// \source Goldhirsch, Granular Matter 12 (2010) 239, for fields from kernels; Capecelatro & Desjardins, J. Comput.
/// Phys.
///         238 (2013) 1, for a Gaussian as the porosity's
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
