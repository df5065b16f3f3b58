// Could a power law have produced this sample? Semi-parametric bootstrap of the distance.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "postprocess/laws/power_law.hpp"

namespace clogflow::postprocess {

enum class LowerEnd { scanned, fixed };  ///< whether x_min was found by the scan or given

struct Bootstrap {
  std::size_t replicates = 1000;  ///< p is known to about 1/(2 sqrt(replicates)) (Clauset et al., sec. 4.1)
  std::uint64_t seed = 1;
  LowerEnd lower_end = LowerEnd::scanned;
};

/// Share of synthetic samples that lie further from their own best power law than the data from
/// theirs. A replicate has n values, each from the fitted power law with probability n_tail/n,
/// otherwise one of the data below x_min; it is fitted as the data were (x_min scanned, or fixed).
/// Small p (ruled_out_below): the power law is ruled out. Large p rules nothing in.
/// \return p in [0, 1]
/// \source Clauset, Shalizi & Newman 2009, SIAM Rev. 51:661, sec. 4.1
double goodness_of_fit(const SortedSample& sample, const PowerLawFit& fit, const Bootstrap& bootstrap);

/// A law with a smaller p-value is called ruled out. \source Clauset et al. 2009, sec. 4.1
inline constexpr double ruled_out_below = 0.1;

/// "p = 0.31", or "p < 0.004" where no replicate lay as far.
std::string p_in_words(double p_value, std::size_t replicates);

/// Rounding noise in p from a finite number of replicates: sqrt(p (1 - p) / replicates).
double p_value_error(double p_value, std::size_t replicates);

}  // namespace clogflow::postprocess
