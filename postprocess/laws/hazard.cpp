#include "postprocess/laws/hazard.hpp"

#include <algorithm>
#include <limits>

#include "postprocess/laws/counting_interval.hpp"

namespace clogflow::postprocess {
namespace {

/// Numbers of the trials after which bins end, the last one left open.
std::vector<std::size_t> inner_edges(const std::vector<TrialCount>& sample, std::size_t fewest) {
  std::vector<std::size_t> events, edges;
  for (const TrialCount& count : sample)
    if (count.ended) events.push_back(count.passed);
  std::ranges::sort(events);
  std::size_t held = 0;
  for (std::size_t i = 0; i < events.size(); ++i) {
    ++held;
    const bool trial_goes_on = i + 1 < events.size() && events[i + 1] == events[i];
    if (held < fewest || trial_goes_on || events.size() - i - 1 < fewest) continue;
    edges.push_back(events[i] + 1);
    held = 0;
  }
  return edges;
}

HazardBin bin_of(const std::vector<TrialCount>& sample, std::size_t from, std::size_t to) {
  HazardBin bin{.from = from, .to = to, .events = 0, .trials = 0, .hazard = {}};
  for (const TrialCount& count : sample) {
    const std::size_t seen = std::min(trials_of(count), to);
    bin.trials += seen > from ? seen - from : 0;
    bin.events += count.ended && count.passed >= from && count.passed < to ? 1 : 0;
  }
  return bin;
}

}  // namespace

Estimate hazard_per_trial(const std::vector<TrialCount>& sample, double level) {
  const TrialSums sums = sums_of(sample);
  return share_from_counts(sums.events, sums.events + sums.passed, level);
}

Estimate mean_of_hazard(const Estimate& hazard) {
  constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
  const auto mean = [](double h) { return h > 0 ? 1 / h - 1 : undefined; };
  return {mean(hazard.value), mean(hazard.high), mean(hazard.low), hazard.note};
}

std::vector<HazardBin> hazard_bins(const std::vector<TrialCount>& sample, std::size_t fewest, double level) {
  std::size_t all = 0;
  for (const TrialCount& count : sample) all = std::max(all, trials_of(count));
  if (all == 0) return {};
  std::vector<std::size_t> edges = inner_edges(sample, fewest);
  edges.push_back(all);
  std::vector<HazardBin> bins;
  for (const std::size_t to : edges) {
    bins.push_back(bin_of(sample, bins.empty() ? 0 : bins.back().to, to));
    bins.back().hazard = share_from_counts(bins.back().events, bins.back().trials, level);
  }
  return bins;
}

}  // namespace clogflow::postprocess
