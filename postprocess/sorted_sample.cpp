// Sorting and tail sums.
#include "postprocess/sorted_sample.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/require.hpp"

namespace clog::postprocess {

SortedSample::SortedSample(std::vector<double> values) : value_(std::move(values)) {
  require(!value_.empty(), "no values to fit (the sample is empty)");
  for (const double x : value_) {
    require(std::isfinite(x) && x > 0,
            "value {} (a power law needs positive finite values): remove it or shift the data", x);
  }
  std::sort(value_.begin(), value_.end());
  logarithm_.resize(size());
  tail_sum_.assign(size() + 1, 0.0);
  // Backwards, so that short tails, which decide x_min, carry the smallest rounding error.
  for (std::size_t i = size(); i-- > 0;) {
    logarithm_[i] = std::log(value_[i]);
    tail_sum_[i] = tail_sum_[i + 1] + logarithm_[i];
  }
  for (std::size_t i = 0; i < size(); ++i) {
    if (i == 0 || value_[i] != value_[i - 1]) distinct_.push_back(i);
  }
}

std::size_t SortedSample::lower_bound(double x) const {
  return static_cast<std::size_t>(std::lower_bound(value_.begin(), value_.end(), x) -
                                  value_.begin());
}

}  // namespace clog::postprocess
