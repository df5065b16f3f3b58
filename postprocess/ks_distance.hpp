// The Kolmogorov-Smirnov distance between a tail and its power law, exact but rarely over all
// points.
#pragma once

#include <cstddef>

#include "postprocess/sorted_sample.hpp"

namespace clog::postprocess {

/// The tail of a sample from index `first` on with its power law: F(x) = 1 - (x_min/x)^(alpha - 1).
struct PowerLawTail {
  std::size_t first = 0;  ///< index of the smallest value that belongs to the tail
  double log_xmin = 0;    ///< ln x_min
  double alpha = 0;       ///< exponent of the density [-]
};

/// Deviation of one point of the tail; D is its maximum.
double ks_deviation(const SortedSample& sample, const PowerLawTail& tail, std::size_t i);

/// Every point of the tail: the definition, O(n).
///   D = max_i |F(z_i) - i/n|,  z_0 <= z_1 <= ... <= z_(n-1) the tail
/// **Rule for ties**: that of Clauset's own `plfit`: the empirical distribution climbs i/n from
/// point to point through a run of equal values, so D sees the step from (almost) both sides. The
/// python package `powerlaw` evaluates only the number of values below, once a distinct value, and
/// may choose another x_min on data with many ties. \source Clauset, Shalizi & Newman 2009, SIAM
/// Rev. 51:661, Eq. (3.9), and their plfit.m
double ks_distance_all_points(const SortedSample& sample, const PowerLawTail& tail);

/// Answers "what is D, if it is at most a limit?" with few evaluations.
///
/// Both F and i/n only grow, so between two evaluated points i < j no deviation exceeds
///   max(F(z_j) - (i+1)/n, (j-1)/n - F(z_i));
/// an interval whose bound is below the largest deviation seen is skipped. Exact: what is skipped
/// cannot be the maximum. The place of the last maximum is tried first, as neighbouring tails share
/// it.
class KsDistance {
public:
  explicit KsDistance(const SortedSample& sample) : sample_(sample) {}

  /// \return D when D <= limit; otherwise some lower bound of D that exceeds the limit
  double up_to(double limit, const PowerLawTail& tail);

private:
  void refine(std::size_t i, std::size_t j, double f_i, double f_j);

  const SortedSample& sample_;
  PowerLawTail tail_;
  double limit_ = 0;
  double largest_ = 0;
  std::size_t where_ = 0;
};

}  // namespace clog::postprocess
