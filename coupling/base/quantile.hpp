// Quantile of unsorted values.
#pragma once

#include <algorithm>
#include <vector>

namespace clogflow {

/// The value that a share of all values does not exceed; reorders them. 0 for no values.
inline double quantile(std::vector<double>& values, double share) {
  if (values.empty()) return 0;
  const auto at = values.begin() + std::min(static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size())),
                                            static_cast<std::ptrdiff_t>(values.size()) - 1);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace clogflow
