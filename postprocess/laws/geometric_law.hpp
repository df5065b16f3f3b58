// Are burst sizes those of a memoryless stopping? A goodness-of-fit test.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace clogflow::postprocess {

struct GeometricTest {
  double ks = 0;       ///< largest distance of the distribution functions [-]
  double p_value = 1;  ///< share of geometric samples that lie further from their own fit
};

/// P(s) = p (1 - p)^(s-1), s = 1, 2, ..., with p = 1/mean: each passage is the last one with the same
/// probability, the exponential law for sizes that are whole numbers. The p-value comes from samples
/// of that law, each compared with the law of its own mean, since p was fitted.
/// \param sizes not empty, each >= 1 \param replicates of the parametric bootstrap, > 0
/// \source Lilliefors 1969, J. Am. Stat. Assoc. 64:387 (exponential with fitted mean)
GeometricTest test_geometric(const std::vector<std::size_t>& sizes, std::size_t replicates, std::uint64_t seed);

}  // namespace clogflow::postprocess
