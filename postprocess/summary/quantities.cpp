// The table of quantities, and their estimates.
#include "postprocess/summary/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "postprocess/laws/censored.hpp"
#include "postprocess/laws/counting_interval.hpp"

namespace clogflow::postprocess {
namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

Estimate mean_size(double stops, double passages, double level) {
  return mean_burst_from_counts(static_cast<std::size_t>(stops), static_cast<std::size_t>(passages), level);
}

/// Sizes from 0 on are sizes from 1 on, less one.
Estimate mean_size_with_zeros(double stops, double passages, double level) {
  const Estimate shifted = mean_size(stops, passages + stops, level);
  return {shifted.value - 1, shifted.low - 1, shifted.high - 1};
}

Estimate share(double part, double whole, double level) {
  return share_from_counts(static_cast<std::size_t>(part), static_cast<std::size_t>(whole), level);
}

Estimate rate(double events, double exposure, double level) {
  return rate_from_counts(static_cast<std::size_t>(events), exposure, level);
}

double ended(const Totals& t) { return t.arrests - t.censored; }

double exponent(const Totals& t) { return ended(t) > 0 ? censored_exponent(ended(t), t.log_exposure) : undefined; }

/// Arrests that were all cut leave an upper bound.
Estimate exponent_from_counts(const Totals& t, double level) {
  const Estimate above_one = rate(ended(t), t.log_exposure, level);
  if (ended(t) == 0) return {undefined, undefined, 1.0 + above_one.high};
  return {1.0 + above_one.value, 1.0 + above_one.low, 1.0 + above_one.high};
}

const std::vector<Quantity> all_quantities{
    {"mean_burst", "1", "<s>: passages per burst, over bursts of one or more",
     "no burst that began and ended within a run", [](const Totals& t) { return t.escaped / t.bursts; },
     [](const Totals& t, double level) { return mean_size(t.bursts, t.escaped, level); }},
    {"mean_burst_with_zeros", "1", "<s> when a release that nothing follows counts as s = 0",
     "no burst that began and ended within a run", [](const Totals& t) { return t.escaped / (t.bursts + t.failed); },
     [](const Totals& t, double level) { return mean_size_with_zeros(t.bursts + t.failed, t.escaped, level); }},
    {"mean_burst_censored", "1", "<s> by maximum likelihood, bursts that the end cut off included",
     "no burst that began and ended within a run",
     [](const Totals& t) { return (t.escaped + t.cut_off_escaped) / t.bursts; },
     [](const Totals& t, double level) { return mean_size(t.bursts, t.escaped + t.cut_off_escaped, level); }},
    {"mean_burst_memoryless", "1", "<s> by maximum likelihood, first bursts and those that the end cut off included",
     "no clog ended a burst", [](const Totals& t) { return all_escaped(t) / all_stops(t); },
     [](const Totals& t, double level) { return mean_size(all_stops(t), all_escaped(t), level); }},
    {"mean_burst_by_threshold", "1", "passages per lapse of T_min and more, whatever ended it",
     "no lapse of T_min or more", [](const Totals& t) { return t.passages / t.arrests; },
     [](const Totals& t, double level) { return mean_size(t.arrests, t.passages, level); }},
    {"share_failed", "1", "share of the releases that no passage follows", "no release",
     [](const Totals& t) { return t.failed / t.releases; },
     [](const Totals& t, double level) { return share(t.failed, t.releases, level); }},
    {"passages_while_off", "1", "passages per release while friction was off (not part of s)", "no release",
     [](const Totals& t) { return t.while_off / t.releases; },
     [](const Totals& t, double level) { return rate(t.while_off, t.releases, level); }},
    {"flow_rate", "1/s", "passages per time, clogs included", "no time",
     [](const Totals& t) { return t.passages / t.time; },
     [](const Totals& t, double level) { return rate(t.passages, t.time, level); }},
    {"flow_rate_flowing", "1/s", "passages per time within bursts", "no lapse below T_min",
     [](const Totals& t) { return t.flowing_lapses / t.flowing_time; },
     [](const Totals& t, double level) { return rate(t.flowing_lapses, t.flowing_time, level); }},
    {"share_clogged", "1", "share of the time spent in lapses of T_min and more", "no time",
     [](const Totals& t) { return t.clogged_time / t.time; }, nullptr},
    {"alpha_fixed", "1", "power-law exponent of T >= T_min, censored arrests included",
     "no arrest that a passage ended", exponent, exponent_from_counts},
    {"share_censored", "1", "share of the arrests that a release or the end of the run cut", "no arrest",
     [](const Totals& t) { return t.censored / t.arrests; },
     [](const Totals& t, double level) { return share(t.censored, t.arrests, level); }},
    {"share_permanent", "1", "share of the seeds that end in a clog of 5 tau or more, or that a clog stopped",
     "no seed", [](const Totals& t) { return t.permanent / t.seeds; },
     [](const Totals& t, double level) { return share(t.permanent, t.seeds, level); }, ShownBy::end_of_run},
    {"first_burst_mean", "1", "<s> of the first, free bursts, one a seed: passages per first clog, none included",
     "no seed clogged", [](const Totals& t) { return t.first_clogs > 0 ? t.until_first / t.first_clogs : undefined; },
     [](const Totals& t, double level) { return mean_size_with_zeros(t.first_clogs, t.until_first, level); },
     ShownBy::end_of_run},
    {"first_burst_hazard", "1", "chance that the first clog comes before the next passage, as if it never changed",
     "no passage and no clog", [](const Totals& t) { return t.first_clogs / (t.first_clogs + t.until_first); },
     [](const Totals& t, double level) { return share(t.first_clogs, t.first_clogs + t.until_first, level); },
     ShownBy::end_of_run},
};

Estimate from_counts(const Quantity& quantity, const Totals& sum, double level) {
  return quantity.counted ? quantity.counted(sum, level) : Estimate{undefined, undefined, undefined};
}

}  // namespace

const std::vector<Quantity>& quantities() { return all_quantities; }

const Quantity* find_quantity(const std::string& key) {
  const auto found = std::ranges::find(all_quantities, key, &Quantity::key);
  return found == all_quantities.end() ? nullptr : &*found;
}

ResampledSums::ResampledSums(const std::vector<Totals>& parts, const Resampling& how)
    : whole(sum_of(parts)), resampling(how) {
  if (parts.size() < 2) return;
  replicates.resize(resampling.replicates);
  draw_seeds(parts.size(), resampling, [&](std::size_t replicate, const std::vector<std::size_t>& drawn) {
    Totals sum;
    for (const std::size_t k : drawn) sum += parts[k];
    replicates[replicate] = sum;
  });
}

namespace {

/// \param of  replicate -> value of the statistic
template <class Of>
Estimate interval_of(double value, const ResampledSums& sums, const Of& of) {
  if (!std::isfinite(value)) return {value, undefined, undefined};
  if (sums.replicates.empty()) return single_seed(value);
  std::vector<double> values(sums.replicates.size());
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = of(k);
  return percentile_interval(value, values, sums.resampling);
}

}  // namespace

Estimate resampled(const Quantity& quantity, const ResampledSums& sums) {
  return interval_of(quantity.value(sums.whole), sums,
                     [&](std::size_t k) { return quantity.value(sums.replicates[k]); });
}

Estimate estimate(const Quantity& quantity, const ResampledSums& seeds) {
  Estimate known = resampled(quantity, seeds);
  if (!std::isfinite(known.value)) {
    const Estimate bound = from_counts(quantity, seeds.whole, seeds.resampling.level);
    return {undefined, bound.low, bound.high, quantity.missing};
  }
  if (!is_spread_missing(known)) return known;
  known = without_interval(known);
  const Estimate exact = from_counts(quantity, seeds.whole, seeds.resampling.level);
  if (!std::isfinite(exact.high)) return known;
  return {known.value, exact.low, exact.high, known.note + "; interval of the counts"};
}

Estimate estimate_change(const Quantity& quantity, const ResampledSums& first, const ResampledSums& second) {
  const Estimate change = interval_of(
      quantity.value(second.whole) - quantity.value(first.whole), first,
      [&](std::size_t k) { return quantity.value(second.replicates[k]) - quantity.value(first.replicates[k]); });
  return is_spread_missing(change) ? without_interval(change) : change;
}

}  // namespace clogflow::postprocess
