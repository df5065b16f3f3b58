// A random factor with a memory.
#pragma once

#include <cmath>

namespace clogflow {

/// One step of an Ornstein-Uhlenbeck process of variance 1, exact for any step; stationary if it begins
/// with a normal number.
///   xi(t + s) = a xi(t) + sqrt(1 - a^2) n,  a = exp(-s / T);  <xi(t) xi(t + s)> = exp(-s / T)
/// \param xi      at t [-]
/// \param n       a normal number of mean 0 and variance 1, independent of xi [-]
/// \param share   s / T, step over correlation time, > 0 [-]
/// \return xi at t + s [-]
/// \source D. T. Gillespie, Phys. Rev. E 54:2084 (1996)
inline double ornstein_uhlenbeck_step(double xi, double n, double share) {
  // 1 - a^2 without loss of digits for a short step.
  return std::exp(-share) * xi + std::sqrt(-std::expm1(-2 * share)) * n;
}

}  // namespace clogflow
