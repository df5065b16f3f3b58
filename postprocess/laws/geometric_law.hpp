// Are burst sizes those of a memoryless stopping? Goodness-of-fit tests.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "postprocess/laws/confidence.hpp"
#include "postprocess/laws/trial_count.hpp"

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

/// The same for counts from 0 on of which some were cut: S(n) = (1 - h)^(n + 1), h = hazard_per_trial, against the
/// Kaplan-Meier function, at its steps and at its end. The made-up samples are cut as this one was.
/// \param sample with at least one event \param replicates > 0
/// \source Efron 1981, J. Am. Stat. Assoc. 76:312 (resampling censored data)
GeometricTest test_geometric_trials(const std::vector<TrialCount>& sample, std::size_t replicates, std::uint64_t seed);

/// A law that is geometric from some trial on: a hazard that is another before it, and constant after it.
struct MemorylessTail {
  std::size_t from = 0;    ///< the first trial of the tail
  std::size_t events = 0;  ///< in the tail
  GeometricTest test;
  Estimate hazard;  ///< of the tail, exact interval
};

/// The longest tail whose geometric law is not ruled out, with at least `fewest` events; found by the data, so that its
/// p-value alone is no proof. Absent where every such tail is ruled out, or none has so many events.
std::optional<MemorylessTail> memoryless_tail(const std::vector<TrialCount>& sample, std::size_t fewest,
                                              std::size_t replicates, const Resampling& resampling);

}  // namespace clogflow::postprocess
