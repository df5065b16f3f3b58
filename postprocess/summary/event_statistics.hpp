// What the bursts and lapses of one ensemble say, as JSON; keys are documented in
// postprocess/README.md.
#pragma once

#include <cstddef>
#include <vector>

#include <nlohmann/json.hpp>

#include "postprocess/events/run_groups.hpp"
#include "postprocess/laws/confidence.hpp"

namespace clogflow::postprocess {

struct StatisticsRequest {
  std::size_t p_value_replicates = 250;  ///< of the goodness of fit: p to 0.03; 0: not computed
  Resampling resampling;                 ///< of the intervals
};

/// Sizes of the bursts that the mean counts: s >= 1, whole; the first of a run only without
/// releases.
std::vector<std::size_t> counted_burst_sizes(const RunGroup& group);

/// Lapses that a passage ended [s].
std::vector<double> whole_lapses(const RunGroup& group);

/// Spread and share of small bursts, beside those of a geometric law; whether they have that law.
nlohmann::json burst_shape(const RunGroup& group, const StatisticsRequest& request);

/// How many lapses and arrests a passage, a release or the end of the run ended; the longest.
nlohmann::json lapse_counts(const RunGroup& group);

/// `free`, `fixed` and `fixed_censored`; each a fit, or {"refused": why}.
nlohmann::json power_laws(const RunGroup& group, const StatisticsRequest& request);

}  // namespace clogflow::postprocess
