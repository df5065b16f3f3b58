// Shape of the burst distribution, fits to the lapses, and what ended them.
#include "postprocess/summary/event_statistics.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "coupling/scene/unclog_protocol.hpp"

namespace clogflow::postprocess {

std::vector<std::size_t> counted_burst_sizes(const RunGroup& group) {
  std::vector<std::size_t> sizes;
  for (const SeedRecord& record : group.records) {
    const bool by_release = clears_clogs(record.protocol);
    for (const Burst& burst : record.bursts) {
      const bool counts = burst.kind == BurstKind::whole || (burst.kind == BurstKind::first && !by_release);
      if (counts && burst.size > 0) sizes.push_back(burst.size);
    }
  }
  return sizes;
}

std::vector<double> whole_lapses(const RunGroup& group) {
  std::vector<double> durations;
  for (const SeedRecord& record : group.records) {
    for (const Lapse& lapse : record.lapses) {
      if (lapse.end == LapseEnd::passage) durations.push_back(lapse.duration);
    }
  }
  return durations;
}

namespace {

BurstSpread spread_of(const std::vector<std::size_t>& sizes, std::uint64_t seed) {
  const auto n = static_cast<double>(sizes.size());
  double mean = 0, square = 0, small = 0;
  for (const std::size_t s : sizes) {
    mean += static_cast<double>(s) / n;
    square += static_cast<double>(s * s) / n;
    small += s <= 3 ? 1.0 / n : 0.0;
  }
  BurstSpread spread;
  spread.largest = *std::max_element(sizes.begin(), sizes.end());
  spread.standard_deviation = std::sqrt(std::max(0.0, square - mean * mean));
  spread.standard_deviation_geometric = std::sqrt(mean * (mean - 1.0));
  spread.share_up_to_3 = small;
  spread.share_up_to_3_geometric = 1.0 - std::pow(1.0 - 1.0 / mean, 3);
  spread.geometric = test_geometric(sizes, geometric_replicates, seed);
  spread.verdict = geometric_verdict(spread.geometric);
  return spread;
}

}  // namespace

Verdict geometric_verdict(const GeometricTest& test) {
  const bool ruled_out = test.p_value < ruled_out_below;
  return {ruled_out, fmt::format("{} ({})", ruled_out ? "ruled out" : "not ruled out",
                                 p_in_words(test.p_value, geometric_replicates))};
}

BurstShape burst_shape(const RunGroup& group, const StatisticsRequest& request) {
  BurstShape shape;
  for (const SeedRecord& record : group.records) {
    for (const Burst& burst : record.bursts) {
      shape.first += burst.kind == BurstKind::first ? 1 : 0;
      shape.cut_off += burst.kind == BurstKind::cut_off ? 1 : 0;
    }
  }
  const auto sizes = counted_burst_sizes(group);
  shape.counted = sizes.size();
  if (!sizes.empty()) shape.spread = spread_of(sizes, request.resampling.seed);
  return shape;
}

namespace {

FitOrRefusal<TailFit> fit_or_refusal(const std::vector<double>& lapses, const FitRequest& request) {
  if (lapses.empty()) return Refusal{"no lapse longer than 0"};
  const SortedSample sample(lapses, Values::continuous);
  if (const std::string why_not = obstacle(sample, request.xmin); !why_not.empty()) return Refusal{why_not};
  return fit_tail(sample, request);
}

Verdict verdict_on(const SurvivalTest& test, std::size_t replicates, double tau) {
  const std::string miss =
      fmt::format("misses the survival curve of the arrests by up to {:.1f} standard errors, most at {:.3g} tau",
                  test.standard_errors, test.at / tau);
  if (replicates == 0) return {false, "not tested: " + miss};
  const std::string p = p_in_words(test.p_value, replicates);
  if (test.p_value < ruled_out_below) return {true, fmt::format("power law ruled out ({}): {}", p, miss)};
  return {false, fmt::format("power law not ruled out ({})", p)};
}

FitOrRefusal<ArrestFit> censored_fit(const RunGroup& group, const StatisticsRequest& request) {
  const auto [tau, threshold] = group.scale;
  std::vector<Observation> arrests;
  bool has_whole = false;
  for (const SeedRecord& record : group.records) {
    for (const Lapse& lapse : arrests_of(record.lapses, threshold)) {
      arrests.push_back(as_observation(lapse));
      has_whole |= !arrests.back().censored && lapse.duration > threshold;
    }
  }
  if (!has_whole) return Refusal{"no arrest that ended with a passage"};
  const std::size_t replicates = request.p_value_replicates;
  const SurvivalTest survival = test_survival(arrests, threshold, replicates, request.resampling.seed);
  return ArrestFit{.law = fit_power_law_censored(arrests, threshold),
                   .exponential = power_law_against_exponential(arrests, threshold),
                   .survival = survival,
                   .p_value_replicates = replicates,
                   .verdict = verdict_on(survival, replicates, tau)};
}

void count(CountsByEnd& counts, LapseEnd end) {
  switch (end) {
    case LapseEnd::passage:
      ++counts.passage;
      break;
    case LapseEnd::release:
      ++counts.release;
      break;
    case LapseEnd::run:
      ++counts.end_of_run;
      break;
  }
}

}  // namespace

LapseCounts lapse_counts(const RunGroup& group) {
  LapseCounts counts;
  for (const SeedRecord& record : group.records) {
    for (const Lapse& lapse : record.lapses) {
      count(counts.lapses, lapse.end);
      if (lapse.duration >= group.scale.threshold) count(counts.arrests, lapse.end);
      counts.zero += lapse.duration == 0 ? 1 : 0;
      counts.longest = std::max(counts.longest, lapse.duration);
    }
  }
  return counts;
}

PowerLaws power_laws(const RunGroup& group, const StatisticsRequest& request) {
  std::vector<double> lapses = whole_lapses(group);
  std::erase(lapses, 0.0);
  FitRequest fit{.xmin = {}, .p_value_replicates = request.p_value_replicates, .seed = request.resampling.seed};
  FitRequest fixed = fit;
  fixed.xmin = group.scale.threshold;
  return {fit_or_refusal(lapses, fit), fit_or_refusal(lapses, fixed), censored_fit(group, request)};
}

}  // namespace clogflow::postprocess
