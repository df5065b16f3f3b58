// Quantiles of values: one of them, or between two of them.
#pragma once

#include <algorithm>
#include <vector>

#include "coupling/base/expect.hpp"

namespace clogflow {

/// The value that a share of all values does not exceed; reorders them. 0 for no values.
template <class T>
T quantile(std::vector<T>& values, double share) {
  expect(share >= 0 && share <= 1);
  if (values.empty()) return 0;
  const auto at = values.begin() + std::min(static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size())),
                                            static_cast<std::ptrdiff_t>(values.size()) - 1);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// The value of which a share lies below, between order statistics by a straight line. \param sorted  not empty
inline double interpolated_quantile(const std::vector<double>& sorted, double share) {
  expect(!sorted.empty() && std::ranges::is_sorted(sorted) && share >= 0 && share <= 1);
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

}  // namespace clogflow
