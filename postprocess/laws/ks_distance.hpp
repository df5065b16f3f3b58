// The Kolmogorov-Smirnov distance between a tail and its law, exact but rarely over all points.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "postprocess/laws/sorted_sample.hpp"

namespace clogflow::postprocess {

/// Points of a tail at which the distribution functions are compared.
struct PointRange {
  std::size_t first = 0, last = 0;  ///< both belong to it
};

/// Distribution function of the law at a point: a step for whole numbers, otherwise one value.
struct LawAt {
  double before = 0;  ///< P(X < x)
  double at = 0;      ///< P(X <= x)
};

/// Answers "what is D, if it is at most a limit?" with few evaluations.
///
/// A tail offers points(sample), law_at(sample, i), deviation(sample, i, law) and bound(sample, i,
/// law_i, j, law_j): what no deviation between two points i < j exceeds, as both distribution
/// functions only grow. An interval whose bound is below the largest deviation seen is skipped.
/// Exact: what is skipped cannot be the maximum. The place of the last maximum is tried first, as
/// neighbouring tails share it.
template <class Tail>
class KsDistance {
public:
  explicit KsDistance(const SortedSample& sample) : sample_(sample) {}

  /// \return D when D <= limit; otherwise some lower bound of D that exceeds the limit
  double up_to(double limit, const Tail& tail);

private:
  void refine(std::size_t i, std::size_t j, const LawAt& law_i, const LawAt& law_j);

  /// std::exp is monotone only up to its last digit; the bound gives that much away.
  static constexpr double rounding = 1e-14;
  static constexpr std::size_t coarse_intervals = 32;

  const SortedSample& sample_;
  Tail tail_{};
  double limit_ = 0;
  double largest_ = 0;
  std::size_t where_ = 0;
};

/// Every point of the tail: the definition, O(n).
template <class Tail>
double ks_distance_all_points(const SortedSample& sample, const Tail& tail) {
  const PointRange points = tail.points(sample);
  double largest = 0;
  for (std::size_t i = points.first; i <= points.last; ++i)
    largest = std::max(largest, tail.deviation(sample, i, tail.law_at(sample, i)));
  return largest;
}

template <class Tail>
double KsDistance<Tail>::up_to(double limit, const Tail& tail) {
  tail_ = tail;
  limit_ = limit;
  const auto [first, last] = tail.points(sample_);
  if (where_ < first || where_ > last) where_ = last;
  largest_ = tail.deviation(sample_, where_, tail.law_at(sample_, where_));
  if (largest_ > limit_) return largest_;

  const std::size_t intervals = std::min(coarse_intervals, last - first);
  std::array<std::size_t, coarse_intervals + 1> point{};
  std::array<LawAt, coarse_intervals + 1> law{};
  for (std::size_t k = 0; k <= intervals; ++k) {
    point[k] = first + (last - first) * k / std::max<std::size_t>(intervals, 1);
    law[k] = tail.law_at(sample_, point[k]);
    const double deviation = tail.deviation(sample_, point[k], law[k]);
    if (deviation > largest_) {
      largest_ = deviation;
      where_ = point[k];
      if (largest_ > limit_) return largest_;
    }
  }
  for (std::size_t k = 0; k < intervals && largest_ <= limit_; ++k) refine(point[k], point[k + 1], law[k], law[k + 1]);
  return largest_;
}

template <class Tail>
void KsDistance<Tail>::refine(std::size_t i, std::size_t j, const LawAt& law_i, const LawAt& law_j) {
  if (j - i < 2 || largest_ > limit_) return;
  if (tail_.bound(sample_, i, law_i, j, law_j) + rounding <= largest_) return;
  const std::size_t middle = i + (j - i) / 2;
  const LawAt law = tail_.law_at(sample_, middle);
  const double deviation = tail_.deviation(sample_, middle, law);
  if (deviation > largest_) {
    largest_ = deviation;
    where_ = middle;
  }
  refine(i, middle, law_i, law);
  refine(middle, j, law, law_j);
}

}  // namespace clogflow::postprocess
