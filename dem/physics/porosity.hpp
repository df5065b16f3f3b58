// Exact share of a sphere between two planes.
#pragma once

#include <algorithm>
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

}  // namespace clogflow
