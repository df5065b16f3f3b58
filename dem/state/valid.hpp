// Whether numbers read from a saved state can be trusted: its checksum guards against damage alone.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace clogflow {

/// All of them are places in an array of `limit`; the padding of an empty array is 0.
inline bool point_below(const std::vector<int>& indices, std::size_t limit) {
  return std::all_of(indices.begin(), indices.end(),
                     [&](int i) { return i >= 0 && static_cast<std::size_t>(i) < std::max<std::size_t>(limit, 1); });
}

inline bool all_finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

/// Of times, lengths and counts.
template <class... Numbers>
bool finite_from_zero(Numbers... numbers) {
  return (... && (std::isfinite(numbers) && numbers >= 0));
}

}  // namespace clogflow
