// Maximum-likelihood fit of a power law, continuous or on whole numbers as the sample is, x_min
// given or found (Clauset, Shalizi & Newman).
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "postprocess/laws/sorted_sample.hpp"

namespace clogflow::postprocess {

struct PowerLawFit {
  double alpha = 0;        ///< exponent of p(x) ~ x^-alpha, a density or a probability [-]
  double xmin = 0;         ///< lower end of the power law [unit of the data]
  double sigma = 0;        ///< standard error of alpha [-]
  double ks = 0;           ///< Kolmogorov-Smirnov distance of the tail [-]
  std::size_t n_tail = 0;  ///< values >= xmin
  std::size_t n = 0;       ///< all values
};

/// Fewest values that are fitted at all; below 50 in the tail a fit is rough (Clauset et al.,
/// sec. 3.3).
inline constexpr std::size_t smallest_sample = 5;
inline constexpr std::size_t rough_below = 50;

/// In words what is done with equal values; goes into every output.
const char* rule_for_ties(Values kind);

/// Why this sample has no fit (with this x_min, if given), or nothing: for callers that go on
/// without.
std::string obstacle(const SortedSample& sample, std::optional<double> xmin);

/// Fit of the values >= xmin, see ParetoTail and ZetaTail.
/// \throws Error with the obstacle: fewer than two values reach xmin, or all of those equal it;
/// xmin is not positive, or not whole although the values are
PowerLawFit fit_power_law(const SortedSample& sample, double xmin);

/// Fit with the x_min, among all distinct values but the largest, whose tail has the smallest
/// Kolmogorov-Smirnov distance (the smallest such x_min when several share it). Exact.
/// \throws Error with the obstacle: fewer than smallest_sample values, or all are equal
/// \source Clauset et al. 2009, sec. 3.3
PowerLawFit fit_power_law(const SortedSample& sample);

/// Whether any x_min gives a distance below the limit: the question of the goodness-of-fit test,
/// which stops at the first such x_min.
bool some_tail_is_closer(const SortedSample& sample, double limit);

/// The same for the one tail that starts at xmin; false where it has fewer than two values.
bool tail_is_closer(const SortedSample& sample, double xmin, double limit);

}  // namespace clogflow::postprocess
