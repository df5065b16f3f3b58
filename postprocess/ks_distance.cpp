// Exact maximum of |F - i/n| by bounding intervals.
#include "postprocess/ks_distance.hpp"

#include <algorithm>
#include <cmath>

namespace clog::postprocess {
namespace {

double model(const SortedSample& sample, const PowerLawTail& tail, std::size_t i) {
  return 1.0 - std::exp((tail.alpha - 1.0) * (tail.log_xmin - sample.logarithm(i)));
}

double rank(const SortedSample& sample, const PowerLawTail& tail, std::size_t i) {
  return static_cast<double>(i - tail.first) / static_cast<double>(sample.size() - tail.first);
}

/// std::exp is monotone only up to its last digit; the bound gives that much away.
constexpr double rounding = 1e-14;

constexpr std::size_t coarse_intervals = 32;

}  // namespace

double ks_deviation(const SortedSample& sample, const PowerLawTail& tail, std::size_t i) {
  return std::abs(model(sample, tail, i) - rank(sample, tail, i));
}

double ks_distance_all_points(const SortedSample& sample, const PowerLawTail& tail) {
  double largest = 0;
  for (std::size_t i = tail.first; i < sample.size(); ++i) {
    largest = std::max(largest, ks_deviation(sample, tail, i));
  }
  return largest;
}

double KsDistance::up_to(double limit, const PowerLawTail& tail) {
  tail_ = tail;
  limit_ = limit;
  const std::size_t last = sample_.size() - 1;
  if (where_ < tail.first || where_ > last) where_ = last;
  largest_ = ks_deviation(sample_, tail, where_);
  if (largest_ > limit_) return largest_;

  const std::size_t intervals = std::min(coarse_intervals, last - tail.first);
  std::size_t point[coarse_intervals + 1];
  double f[coarse_intervals + 1];
  for (std::size_t k = 0; k <= intervals; ++k) {
    point[k] = tail.first + (last - tail.first) * k / std::max<std::size_t>(intervals, 1);
    f[k] = model(sample_, tail, point[k]);
    const double deviation = std::abs(f[k] - rank(sample_, tail, point[k]));
    if (deviation > largest_) {
      largest_ = deviation;
      where_ = point[k];
      if (largest_ > limit_) return largest_;
    }
  }
  for (std::size_t k = 0; k < intervals && largest_ <= limit_; ++k) {
    refine(point[k], point[k + 1], f[k], f[k + 1]);
  }
  return largest_;
}

void KsDistance::refine(std::size_t i, std::size_t j, double f_i, double f_j) {
  if (j - i < 2 || largest_ > limit_) return;
  const double bound =
      std::max(f_j - rank(sample_, tail_, i + 1), rank(sample_, tail_, j - 1) - f_i);
  if (bound + rounding <= largest_) return;
  const std::size_t middle = i + (j - i) / 2;
  const double f = model(sample_, tail_, middle);
  const double deviation = std::abs(f - rank(sample_, tail_, middle));
  if (deviation > largest_) {
    largest_ = deviation;
    where_ = middle;
  }
  refine(i, middle, f_i, f);
  refine(middle, j, f, f_j);
}

}  // namespace clog::postprocess
