// Writes the tables of events and distributions.
#include "postprocess/output/tables.hpp"

#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "postprocess/laws/distributions.hpp"
#include "postprocess/laws/survival.hpp"
#include "postprocess/summary/event_statistics.hpp"
#include "postprocess/summary/first_burst_statistics.hpp"

namespace clogflow::postprocess {
namespace {

using Out = std::back_insert_iterator<std::string>;

void add_lapses(Out out, const RunGroup& group, std::size_t index) {
  for (const SeedRecord& record : group.records) {
    for (const Lapse& lapse : record.lapses) {
      fmt::format_to(out, "{},{},{},{},{},{}\n", index, record.seed, lapse.start, lapse.duration,
                     lapse.duration / group.scale.tau, name(lapse.end));
    }
  }
}

void add_arrests(Out out, const RunGroup& group, std::size_t index) {
  for (const SeedRecord& record : group.records) {
    for (const Lapse& lapse : arrests_of(record.lapses, group.scale.threshold)) {
      fmt::format_to(out, "{},{},{},{},{},{},{}\n", index, record.seed, lapse.start, lapse.duration,
                     lapse.duration / group.scale.tau, name(lapse.end), lapse.end == LapseEnd::passage ? 0 : 1);
    }
  }
}

void add_bursts(Out out, const RunGroup& group, std::size_t index) {
  for (const SeedRecord& record : group.records) {
    for (const Burst& burst : record.bursts) {
      fmt::format_to(out, "{},{},{},{},{},{},{}\n", index, record.seed, burst.start, burst.duration, burst.size,
                     burst.while_off, name(burst.kind));
    }
  }
}

void add_burst_distribution(Out out, const RunGroup& group, std::size_t index) {
  const auto sizes = counted_burst_sizes(group);
  if (sizes.empty()) return;
  const double mean = static_cast<double>(std::accumulate(sizes.begin(), sizes.end(), std::size_t{0})) /
                      static_cast<double>(sizes.size());
  for (const Bin& bin : burst_histogram(sizes)) {
    const double centre = 0.5 * (bin.from + bin.to);
    fmt::format_to(out, "{},{},{},{},{},{},{}\n", index, bin.from, bin.to, centre / mean, bin.count, bin.density * mean,
                   bin.error * mean);
  }
}

void add_lapse_distribution(Out out, const RunGroup& group, std::size_t index) {
  const double tau = group.scale.tau;
  for (const Bin& bin : logarithmic_histogram(whole_lapses(group))) {
    fmt::format_to(out, "{},{},{},{},{},{}\n", index, bin.from / tau, bin.to / tau, bin.count, bin.density * tau,
                   bin.error * tau);
  }
}

/// Kaplan-Meier estimate of the lapses of at least `shortest` [s].
void add_survival(Out out, const RunGroup& group, std::size_t index, double shortest) {
  std::vector<Observation> sample;
  for (const SeedRecord& record : group.records) {
    for (const Lapse& lapse : arrests_of(record.lapses, shortest)) sample.push_back(as_observation(lapse));
  }
  for (const SurvivalStep& step : kaplan_meier(std::move(sample))) {
    fmt::format_to(out, "{},{},{},{},{},{},{}\n", index, step.time, step.time / group.scale.tau, step.survival,
                   step.error, step.at_risk, step.ended);
  }
}

void add_first_bursts(Out out, const RunGroup& group, std::size_t index) {
  for (const SeedRecord& record : group.records) {
    const FirstBurst& burst = record.first_burst;
    fmt::format_to(out, "{},{},{},{},{},{},{}\n", index, record.seed, burst.size, burst.clogged ? 1 : 0,
                   cell(burst.clog_position.value_or(NAN)), cell(burst.packing_flowing), cell(burst.packing_at_end));
  }
}

/// S(n) is the share of the seeds that more than n particles pass before the first clog.
void add_first_burst_survival(Out out, const RunGroup& group, std::size_t index) {
  for (const SurvivalStep& step : kaplan_meier(as_observations(first_bursts(group))))
    fmt::format_to(out, "{},{},{},{},{},{}\n", index, step.time, step.survival, step.error, step.at_risk, step.ended);
}

void add_first_burst_hazard(Out out, const RunGroup& group, std::size_t index) {
  for (const HazardBin& bin : hazard_bins(first_bursts(group), events_per_hazard_bin, Resampling{}.level))
    fmt::format_to(out, "{},{},{},{},{},{},{},{}\n", index, bin.from, bin.to, bin.events, bin.trials, bin.hazard.value,
                   bin.hazard.low, bin.hazard.high);
}

template <class Add>
Table table(const char* file, const char* header, const std::vector<RunGroup>& groups, const Add& add) {
  Table table{file, fmt::format("{}\n", header)};
  for (std::size_t i = 0; i < groups.size(); ++i) add(std::back_inserter(table.text), groups[i], i);
  return table;
}

}  // namespace

std::string cell(double value) { return std::isfinite(value) ? fmt::format("{}", value) : ""; }

std::vector<Table> tables_of(const std::vector<RunGroup>& groups) {
  constexpr const char* survival = "group,T [s],T/tau [1],S [1],error [1],at_risk,ended";
  return {
      table("lapses.csv", "group,seed,start [s],T [s],T/tau [1],ended_by", groups, add_lapses),
      table("arrests.csv", "group,seed,start [s],T [s],T/tau [1],ended_by,censored", groups, add_arrests),
      table("bursts.csv", "group,seed,start [s],duration [s],s [1],while_off [1],kind", groups, add_bursts),
      table("burst_distribution.csv", "group,s_from [1],s_to [1],s/<s> [1],count,P [1],error [1]", groups,
            add_burst_distribution),
      table("lapse_distribution.csv", "group,T/tau_from [1],T/tau_to [1],count,P [1],error [1]", groups,
            add_lapse_distribution),
      table("lapse_survival.csv", survival, groups,
            [](Out out, const RunGroup& group, std::size_t i) { add_survival(out, group, i, 0.0); }),
      table("arrest_survival.csv", survival, groups,
            [](Out out, const RunGroup& group, std::size_t i) { add_survival(out, group, i, group.scale.threshold); }),
      table("first_bursts.csv",
            "group,seed,s [1],clogged,clog_position [m],packing_near_neck_flowing [1],packing_near_neck_at_end [1]",
            groups, add_first_bursts),
      table("first_burst_survival.csv", "group,n [1],S [1],error [1],at_risk,ended", groups, add_first_burst_survival),
      table("first_burst_hazard.csv", "group,n_from [1],n_to [1],clogs,trials,hazard [1],low [1],high [1]", groups,
            add_first_burst_hazard),
  };
}

}  // namespace clogflow::postprocess
