// A sample sorted once, with the sums that every candidate x_min needs.
#pragma once

#include <cstddef>
#include <vector>

#include "coupling/base/expect.hpp"

namespace clogflow::postprocess {

/// What the values are decides which law describes them.
enum class Values {
  continuous,  ///< any positive numbers: p(x) ~ x^-alpha is a density
  whole,       ///< counts: p(x) ~ x^-alpha is a probability, on whole numbers only
};

/// Whole when every value is a whole number, unless all exceed 1000: there the two laws agree.
/// \source Clauset's plfit, which chooses in this way
Values recognised(const std::vector<double>& values);

/// Positive values in ascending order with their logarithms and the sums over each tail, so that
/// the exponent of any tail costs O(1).
class SortedSample {
public:
  /// \throws Error on a value that is not positive and finite, on one that is not whole if they are
  /// to be, or on an empty sample
  explicit SortedSample(std::vector<double> values, Values kind = Values::continuous);

  Values kind() const { return kind_; }

  std::size_t size() const { return value_.size(); }
  double value(std::size_t i) const { return value_[i]; }
  double logarithm(std::size_t i) const { return logarithm_[i]; }

  /// sum of ln x_i over i >= first
  double sum_of_logarithms(std::size_t first) const {
    expect(first <= size());
    return tail_sum_[first];
  }

  /// Share of the tail from `first` on that lies before index i: its empirical distribution function.
  double share_before(std::size_t first, std::size_t i) const {
    return static_cast<double>(i - first) / static_cast<double>(size() - first);
  }

  /// Index of the first value >= x.
  std::size_t lower_bound(double x) const;

  /// Index where each distinct value first occurs, ascending.
  const std::vector<std::size_t>& distinct() const { return distinct_; }

private:
  Values kind_;
  std::vector<double> value_, logarithm_, tail_sum_;
  std::vector<std::size_t> distinct_;
};

}  // namespace clogflow::postprocess
