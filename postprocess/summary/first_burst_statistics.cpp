#include "postprocess/summary/first_burst_statistics.hpp"

#include <cmath>

#include "postprocess/laws/counting_interval.hpp"

namespace clogflow::postprocess {
namespace {

/// Mean over the seeds that know the value.
Estimate over_seeds(const RunGroup& group, double FirstBurst::*member, const Resampling& resampling) {
  std::vector<double> values;
  for (const SeedRecord& record : group.records)
    if (std::isfinite(record.first_burst.*member)) values.push_back(record.first_burst.*member);
  if (values.empty()) return {NAN, NAN, NAN, "no seed shows it"};
  return mean_over_seeds(values, resampling);
}

ClogPlaces places_of(const RunGroup& group, double level) {
  ClogPlaces places;
  for (const SeedRecord& record : group.records) {
    const FirstBurst& burst = record.first_burst;
    if (!burst.clogged || !burst.clog_position) continue;
    ++places.known;
    places.upstream += *burst.clog_position < -group.scene.geometry.neck_width ? 1 : 0;
  }
  places.share_upstream = share_from_counts(places.upstream, places.known, level);
  if (places.known == 0) places.share_upstream.note = "no run says where its clog stood";
  return places;
}

}  // namespace

std::vector<TrialCount> first_bursts(const RunGroup& group) {
  std::vector<TrialCount> sample;
  for (const SeedRecord& record : group.records) sample.push_back(as_trials(record.first_burst));
  return sample;
}

FirstBurstStatistics first_burst_statistics(const RunGroup& group, const StatisticsRequest& request) {
  const auto sample = first_bursts(group);
  const TrialSums sums = sums_of(sample);
  const double level = request.resampling.level;
  FirstBurstStatistics result{.seeds = sample.size(),
                              .clogged = sums.events,
                              .passages = sums.passed,
                              .largest = sums.largest,
                              .jammed_starts = 0,
                              .mean = mean_count(sample, request.resampling),
                              .hazard = hazard_per_trial(sample, level),
                              .hazard_bins = hazard_bins(sample, events_per_hazard_bin, level),
                              .survival = kaplan_meier(as_observations(sample)),
                              .geometric = {},
                              .verdict = {},
                              .tail = {},
                              .packing = {over_seeds(group, &FirstBurst::packing_flowing, request.resampling),
                                          over_seeds(group, &FirstBurst::packing_at_end, request.resampling)},
                              .places = places_of(group, level)};
  for (const SeedRecord& record : group.records) result.jammed_starts += record.start_flowed.value_or(true) ? 0 : 1;
  result.verdict.words = "not tested: no seed clogged";
  if (sums.events > 0) {
    result.geometric = test_geometric_trials(sample, geometric_replicates, request.resampling.seed);
    result.verdict = geometric_verdict(*result.geometric);
    if (result.verdict.ruled_out)
      result.tail = memoryless_tail(sample, events_of_memoryless_tail, geometric_replicates, request.resampling);
  }
  return result;
}

}  // namespace clogflow::postprocess
