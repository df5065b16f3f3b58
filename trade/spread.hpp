// Numbers spread evenly over an interval, the same on every machine.
#pragma once

#include <cmath>

namespace clogflow {

/// Number `index` of the van der Corput sequence of a prime, in [0, 1).
inline double halton(int index, int base) {
  double value = 0, share = 1;
  for (; index > 0; index /= base) value += (share /= base) * (index % base);
  return value;
}

/// Point `index` of the multiples of a prime's root, in [0, 1).
inline double root_spread(int index, int prime) { return std::fmod(index * std::sqrt(prime), 1.0); }

/// At a share of the way from low to high, in the logarithm.
inline double log_between(double share, double low, double high) { return low * std::pow(high / low, share); }

}  // namespace clogflow
