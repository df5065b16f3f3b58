// A tail of continuous values with its power law.
#pragma once

#include <cstddef>

#include "coupling/base/random_stream.hpp"
#include "postprocess/laws/ks_distance.hpp"
#include "postprocess/laws/sorted_sample.hpp"

namespace clogflow::postprocess {

/// The tail of a sample from index `first` on with the law F(x) = 1 - (x_min/x)^(alpha - 1).
///
/// D = max_i |F(z_i) - i/n|,  z_0 <= z_1 <= ... <= z_(n-1) the tail
/// **Rule for ties**: that of Clauset's own `plfit`: the empirical distribution climbs i/n from
/// point to point through a run of equal values, so D sees the step from (almost) both sides. The
/// python package `powerlaw` evaluates only the number of values below, once a distinct value, and
/// may choose another x_min on data with many ties.
/// \source Clauset, Shalizi & Newman 2009, SIAM Rev. 51:661, Eqs. (3.1), (3.9), and their plfit.m
struct ParetoTail {
  std::size_t first = 0;  ///< index of the smallest value that belongs to the tail
  double log_xmin = 0;    ///< ln x_min
  double alpha = 0;       ///< exponent of the density [-]

  /// alpha = 1 + n [sum_i ln(x_i / x_min)]^-1
  static ParetoTail of(const SortedSample& sample, std::size_t first, double xmin);

  PointRange points(const SortedSample& sample) const { return {first, sample.size() - 1}; }
  LawAt law_at(const SortedSample& sample, std::size_t i) const;
  double deviation(const SortedSample& sample, std::size_t i, const LawAt& law) const;
  double bound(const SortedSample& sample, std::size_t i, const LawAt& law_i, std::size_t j, const LawAt& law_j) const;

  /// Standard error of alpha: (alpha - 1)/sqrt(n), Eq. (3.2)
  double sigma(const SortedSample& sample) const;
};

/// Draws from the same law: the inverse of F.
class ParetoVariates {
public:
  ParetoVariates(double alpha, double xmin) : alpha_(alpha), xmin_(xmin) {}
  double operator()(RandomStream& random) const;

private:
  double alpha_, xmin_;
};

}  // namespace clogflow::postprocess
