// What the bursts and lapses of one ensemble say.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "postprocess/events/run_groups.hpp"
#include "postprocess/laws/confidence.hpp"
#include "postprocess/laws/geometric_law.hpp"
#include "postprocess/laws/survival_test.hpp"
#include "postprocess/laws/tail_fit.hpp"

namespace clogflow::postprocess {

struct StatisticsRequest {
  std::size_t p_value_replicates = 250;  ///< of the goodness of fit: p to 0.03; 0: not computed
  Resampling resampling = {};            ///< of the intervals
};

/// Sizes of the bursts that the mean counts: s >= 1, whole; the first of a run only without
/// releases.
std::vector<std::size_t> counted_burst_sizes(const RunGroup& group);

/// Lapses that a passage ended [s].
std::vector<double> whole_lapses(const RunGroup& group);

/// Whether a tested law is ruled out, and the same in words.
struct Verdict {
  bool ruled_out = false;
  std::string words;
};

/// Samples that a test of the geometric law makes up: p to 0.016 at most.
inline constexpr std::size_t geometric_replicates = 1000;

Verdict geometric_verdict(const GeometricTest& test);

/// Spread and share of small bursts, beside those of a geometric law (memoryless stopping) of the same mean.
struct BurstSpread {
  std::size_t largest = 0;
  double standard_deviation = 0, standard_deviation_geometric = 0;
  double share_up_to_3 = 0, share_up_to_3_geometric = 0;
  GeometricTest geometric;
  Verdict verdict;  ///< on the geometric law
};

struct BurstShape {
  std::size_t counted = 0;  ///< behind the mean
  std::size_t first = 0, cut_off = 0;
  std::optional<BurstSpread> spread;  ///< absent where no burst counts
};

BurstShape burst_shape(const RunGroup& group, const StatisticsRequest& request);

/// How many a passage, a release or the end of the run ended.
struct CountsByEnd {
  std::size_t passage = 0, release = 0, end_of_run = 0;
};

struct LapseCounts {
  CountsByEnd lapses, arrests;
  std::size_t zero = 0;  ///< lapses of two passages in one step
  double longest = 0;    ///< [s]
};

LapseCounts lapse_counts(const RunGroup& group);

/// Power law of the arrests, those that were cut included, held against their survival function.
struct ArrestFit {
  CensoredFit law;
  RivalTest exponential;
  SurvivalTest survival;
  std::size_t p_value_replicates = 0;  ///< 0: not tested, only the words hold
  Verdict verdict;                     ///< on the power law
};

/// Of the lapses: x_min scanned, x_min = T_min, and that with censored arrests.
struct PowerLaws {
  FitOrRefusal<TailFit> free, fixed;
  FitOrRefusal<ArrestFit> fixed_censored;
};

PowerLaws power_laws(const RunGroup& group, const StatisticsRequest& request);

}  // namespace clogflow::postprocess
