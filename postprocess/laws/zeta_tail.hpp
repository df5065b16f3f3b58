// A tail of whole numbers with its power law.
#pragma once

#include <cstddef>
#include <vector>

#include "coupling/base/random_stream.hpp"
#include "postprocess/laws/ks_distance.hpp"
#include "postprocess/laws/sorted_sample.hpp"

namespace clogflow::postprocess {

/// P(X >= x) for whole x >= x_min under p(x) = x^-alpha / zeta(alpha, x_min).
double zeta_survival(double alpha, double xmin, double x);

/// The exponent that makes the mean of ln(x/x_min) what it is in the data, which is the maximum of
/// the likelihood  L = -n ln zeta(alpha, x_min) - alpha sum ln x_i; infinite for a mean of 0.
/// \source Clauset, Shalizi & Newman 2009, Eq. (3.5)
double zeta_exponent(double mean_logarithm, double xmin);

/// The tail of a sample from index `first` on with the law p(x) = x^-alpha / zeta(alpha, x_min),
/// x = x_min, x_min + 1, ...
///
/// D = max_x |P(X <= x) - S(x)| over all whole x >= x_min, S(x) the share of values <= x. Both are
/// steps, so it is enough to look at the distinct values and just before them; the points are the
/// distinct values.
/// \source Clauset, Shalizi & Newman 2009, SIAM Rev. 51:661, sec. 3 and Eq. (3.9)
struct ZetaTail {
  std::size_t first = 0;           ///< index of the smallest value that belongs to the tail
  std::size_t first_distinct = 0;  ///< the same among the distinct values
  double xmin = 1;
  double alpha = 0;  ///< [-]
  double norm = 1;   ///< x_min^alpha zeta(alpha, x_min)

  static ZetaTail of(const SortedSample& sample, std::size_t first, double xmin);

  PointRange points(const SortedSample& sample) const;
  LawAt law_at(const SortedSample& sample, std::size_t k) const;
  double deviation(const SortedSample& sample, std::size_t k, const LawAt& law) const;
  double bound(const SortedSample& sample, std::size_t k, const LawAt& law_k, std::size_t l, const LawAt& law_l) const;

  /// Standard error of alpha: [n (zeta''/zeta - (zeta'/zeta)^2)]^-1/2, Eq. (3.6)
  double sigma(const SortedSample& sample) const;

private:
  /// Share of the tail below the distinct value number k.
  double share_below(const SortedSample& sample, std::size_t k) const;
};

/// Draws from the same law: the largest x with P(X >= x) >= u (their appendix D), from a table
/// where nearly all draws fall and by doubling and bisection beyond it.
class ZetaVariates {
public:
  ZetaVariates(double alpha, double xmin);
  double operator()(RandomStream& random) const;

private:
  double beyond_table(double u) const;

  double alpha_, xmin_;
  std::vector<double> survival_;  // of x_min, x_min + 1, ...
};

}  // namespace clogflow::postprocess
