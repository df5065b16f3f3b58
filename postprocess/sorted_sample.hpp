// A sample sorted once, with the sums that every candidate x_min needs.
#pragma once

#include <cstddef>
#include <vector>

namespace clog::postprocess {

/// Positive values in ascending order with their logarithms and the sums over each tail, so that
/// the exponent of any tail costs O(1).
class SortedSample {
public:
  /// \throws Error on a value that is not positive and finite, or on an empty sample
  explicit SortedSample(std::vector<double> values);

  std::size_t size() const { return value_.size(); }
  double value(std::size_t i) const { return value_[i]; }
  double logarithm(std::size_t i) const { return logarithm_[i]; }

  /// sum of ln x_i over i >= first
  double sum_of_logarithms(std::size_t first) const { return tail_sum_[first]; }

  /// Index of the first value >= x.
  std::size_t lower_bound(double x) const;

  /// Index where each distinct value first occurs, ascending.
  const std::vector<std::size_t>& distinct() const { return distinct_; }

private:
  std::vector<double> value_, logarithm_, tail_sum_;
  std::vector<std::size_t> distinct_;
};

}  // namespace clog::postprocess
