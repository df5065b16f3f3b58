// Sorting and tail sums.
#include "postprocess/laws/sorted_sample.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/base/require.hpp"

namespace clogflow::postprocess {

namespace {

constexpr double laws_agree_from = 1000;

bool is_whole(double x) { return std::floor(x) == x; }

}  // namespace

Values recognised(const std::vector<double>& values) {
  const bool whole = std::ranges::all_of(values, is_whole);
  const bool large = std::ranges::all_of(values, [](double x) { return x > laws_agree_from; });
  return whole && !large ? Values::whole : Values::continuous;
}

SortedSample::SortedSample(std::vector<double> values, Values kind) : kind_(kind), value_(std::move(values)) {
  require(!value_.empty(), "no values to fit (the sample is empty)");
  for (const double x : value_) {
    require(std::isfinite(x) && x > 0,
            "value {} (a power law needs positive finite values): remove it or shift the data", x);
    require(kind == Values::continuous || is_whole(x), "value {} (a discrete power law needs whole numbers)", x);
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
  return static_cast<std::size_t>(std::lower_bound(value_.begin(), value_.end(), x) - value_.begin());
}

}  // namespace clogflow::postprocess
