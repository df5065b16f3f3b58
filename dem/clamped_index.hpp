// From a number of any size to a place in an array.
#pragma once

namespace clog {

/// The whole number below `value`, held within [0, count); 0 for NaN. A conversion alone is undefined for
/// what no int can hold, and a particle in free flight may be anywhere.
inline int clamped_index(double value, int count) {
  if (!(value >= 1)) return 0;
  return value < count ? static_cast<int>(value) : count - 1;
}

}  // namespace clog
