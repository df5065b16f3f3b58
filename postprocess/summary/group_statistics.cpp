// Assembles the numbers of one ensemble.
#include "postprocess/summary/group_statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "coupling/base/require.hpp"
#include "coupling/scene/unclog_protocol.hpp"

namespace clogflow::postprocess {
namespace {

std::vector<std::array<Totals, 2>> halves_of(const RunGroup& group) {
  std::vector<std::array<Totals, 2>> halves;
  for (const SeedRecord& record : group.records) {
    const auto [start, end] = record.window;
    const double middle = 0.5 * (start + end);
    // The last passage may fall on the end itself.
    halves.push_back({totals_of(record, group.scale, {start, middle}),
                      totals_of(record, group.scale, {middle, std::nextafter(end, 2.0 * end)})});
  }
  return halves;
}

std::vector<QuantityStatistics> quantities_with_halves(const RunGroup& group, const StatisticsRequest& request) {
  const auto halves = halves_of(group);
  std::vector<Totals> first, second, whole;
  for (const auto& [a, b] : halves) {
    first.push_back(a);
    second.push_back(b);
    whole.push_back(a + b);
    whole.back().seeds = 1;
  }
  const ResampledSums sums(whole, request.resampling), before(first, request.resampling),
      after(second, request.resampling);
  std::vector<QuantityStatistics> all;
  for (const Quantity& quantity : quantities()) {
    all.push_back({&quantity, estimate(quantity, sums), {}});
    if (quantity.shown_by == ShownBy::end_of_run) continue;
    const Estimate change = estimate_change(quantity, before, after);
    all.back().halves = Ageing{.first_half = estimate(quantity, before),
                               .second_half = estimate(quantity, after),
                               .change = change,
                               .drifts = {}};
    if (std::isfinite(change.low)) all.back().halves->drifts = change.low > 0 || change.high < 0;
  }
  return all;
}

SteadyStatistics steady_state(const RunGroup& group, const StatisticsRequest& request) {
  const auto mean = [&](auto&& value) {
    std::vector<double> values;
    for (const SeedRecord& record : group.records) values.push_back(value(record.steady));
    return mean_over_seeds(values, request.resampling);
  };
  SteadyStatistics steady{.particles = mean([](const SteadyState& s) { return s.particles; }),
                          .packing_fraction = mean([](const SteadyState& s) { return s.packing_fraction; }),
                          .porosity = {}};
  for (std::size_t strip = 0; strip < group.records.front().steady.porosity.size(); ++strip) {
    steady.porosity.push_back(mean([&](const SteadyState& s) {
      return strip < s.porosity.size() ? s.porosity[strip] : std::numeric_limits<double>::quiet_NaN();
    }));
  }
  return steady;
}

/// Bursts that depend on each other have no interval from their counts.
void widen(std::vector<QuantityStatistics>& quantities, const RunGroup& group, const Resampling& resampling) {
  for (QuantityStatistics& each : quantities) {
    for (const char* key : {"mean_burst", "mean_burst_with_zeros", "mean_burst_censored", "mean_burst_memoryless"})
      if (each.quantity->key == key && std::isfinite(each.whole.value))
        each.whole = dependent_estimate(*each.quantity, group, resampling);
  }
}

std::vector<std::string> notes(const RunGroup& group, const GroupStatistics& numbers) {
  std::vector<std::string> notes;
  if (group.scene.contact.torsion_update == TorsionUpdate::doubling) {
    notes.emplace_back("contact.torsion_update = \"doubling\": an experiment, the springs are not objective");
  }
  if (group.scene.drag.fluctuation.strength > 0) notes.emplace_back("drag.fluctuation is on");
  if (group.scene.flow.pulsation.strength > 0) notes.emplace_back("flow.pulsation is on");
  if (group.scene.flow.oscillation.on())
    notes.emplace_back("flow.oscillation is on: lapses and arrests are in time, slow flow lengthens them too");
  if (group.scene.flow.balances())
    notes.emplace_back(
        "a balance of pressures drives the flow: lapses and arrests are in time, slow flow lengthens them too");
  if (clears_clogs(group.scene.unclog.protocol)) {
    notes.emplace_back(
        "clogs are ended by releases: arrests are censored, alpha describes only those that end by "
        "themselves");
  }
  if (group.scene.unclog.protocol == UnclogProtocol::stop)
    notes.emplace_back("runs end at their first clog: alpha describes only the arrests that end by themselves");
  if (numbers.first_burst.jammed_starts > 0)
    notes.emplace_back(
        fmt::format("{} of {} seeds jammed before they had flowed as inlet.strain asks; they count as bursts of "
                    "their passages all the same",
                    numbers.first_burst.jammed_starts, numbers.first_burst.seeds));
  if (numbers.burst_order && numbers.burst_order->depends) notes.push_back(numbers.burst_order->words);
  if (std::string words = cut_off_words(numbers); !words.empty()) notes.push_back(std::move(words));
  if (!group.necks.empty())
    notes.push_back(
        fmt::format("{} necks side by side: without a word a number is of all together, so that a clog is one of all "
                    "at once; the flow is not diverted from a neck that is clogged",
                    group.necks.size()));
  if (group.records.size() < 2) notes.emplace_back("a single seed: no intervals");
  return notes;
}

}  // namespace

const QuantityStatistics& GroupStatistics::of(const std::string& key) const {
  const auto found = std::ranges::find(quantities, key, [](const auto& each) { return each.quantity->key; });
  require(found != quantities.end(), "no quantity {}", key);
  return *found;
}

std::string cut_off_words(const GroupStatistics& numbers) {
  constexpr double few = 0.1;
  const Estimate &whole = numbers.of("mean_burst").whole, &all = numbers.of("mean_burst_memoryless").whole;
  const std::size_t cut = numbers.bursts.cut_off, bursts = numbers.bursts.counted + cut;
  const bool many = static_cast<double>(cut) > few * static_cast<double>(bursts);
  if (cut == 0 || !std::isfinite(whole.value) || !(all.value > whole.value)) return "";
  if (!many && !(all.value > whole.high)) return "";
  return fmt::format(
      "the end of the runs cut {} of {} bursts off, long ones more often: <s> leaves them out and is too small; over "
      "all passages and clogs it is {:.3g} [{:.3g}, {:.3g}] (mean_burst_memoryless)",
      cut, bursts, all.value, all.low, all.high);
}

GroupStatistics group_statistics(const RunGroup& group, const StatisticsRequest& request) {
  GroupStatistics numbers{.label = {},
                          .quantities = quantities_with_halves(group, request),
                          .first_burst = first_burst_statistics(group, request),
                          .burst_order = burst_order(group, request.resampling),
                          .bursts = burst_shape(group, request),
                          .lapses = lapse_counts(group),
                          .power_laws = power_laws(group, request),
                          .steady = steady_state(group, request),
                          .necks = {},
                          .sizes = size_statistics(group, request.resampling),
                          .notes = {}};
  if (numbers.burst_order && numbers.burst_order->depends) widen(numbers.quantities, group, request.resampling);
  numbers.notes = notes(group, numbers);
  for (const std::vector<SeedRecord>& records : group.necks) {
    RunGroup neck = group;
    neck.records = records;
    neck.necks.clear();
    numbers.necks.push_back(group_statistics(neck, request));
  }
  return numbers;
}

}  // namespace clogflow::postprocess
