#include "postprocess/laws/restricted_mean.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "postprocess/laws/hazard.hpp"
#include "postprocess/laws/survival.hpp"

namespace clogflow::postprocess {

namespace {

double area_below(const std::vector<SurvivalStep>& steps, std::size_t up_to) {
  double area = 0, survival = 1;
  std::size_t from = 0;
  for (const SurvivalStep& step : steps) {
    const auto trial = static_cast<std::size_t>(step.time);
    if (trial >= up_to) break;
    area += survival * static_cast<double>(trial - from);
    from = trial;
    survival = step.survival;
  }
  return area + survival * static_cast<double>(up_to - from);
}

/// Place of each count in the sorted ends, so that a resampled ensemble is counted and not sorted.
std::vector<std::size_t> places_in(const std::vector<EndsAt>& ends, const std::vector<TrialCount>& sample) {
  std::vector<std::size_t> places;
  for (const TrialCount& count : sample)
    places.push_back(static_cast<std::size_t>(
        std::ranges::lower_bound(ends, as_observation(count).value, {}, &EndsAt::time) - ends.begin()));
  return places;
}

}  // namespace

double restricted_mean(const std::vector<TrialCount>& sample, std::size_t up_to) {
  return area_below(kaplan_meier(ends_of(sample)), up_to);
}

MeanCount mean_count(const std::vector<TrialCount>& sample, const Resampling& resampling) {
  constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
  const TrialSums sums = sums_of(sample);
  const Estimate memoryless = mean_of_hazard(hazard_per_trial(sample, resampling.level));
  if (sums.events == 0)
    return {{undefined, memoryless.low, undefined, "no event: bound of a law without memory"}, sums.largest};
  MeanCount result{.mean = {}, .up_to = sums.largest};
  result.is_restricted = kaplan_meier(ends_of(sample)).back().survival > 0;
  std::vector<EndsAt> none = ends_of(sample);
  const std::vector<std::size_t> places = places_in(none, sample);
  for (EndsAt& each : none) each.ended = each.cut = 0;
  result.mean = bootstrap_over_seeds(
      sample.size(),
      [&](const std::vector<std::size_t>& drawn) {
        std::vector<EndsAt> again = none;
        for (const std::size_t k : drawn) ++(sample[k].ended ? again[places[k]].ended : again[places[k]].cut);
        return area_below(kaplan_meier(again), sums.largest);
      },
      resampling);
  if (!std::isfinite(result.mean.low) || !is_spread_missing(result.mean)) return result;
  const std::string why = without_interval(result.mean).note;
  result.mean = {result.mean.value, memoryless.low, memoryless.high, why + "; interval of the counts"};
  return result;
}

}  // namespace clogflow::postprocess
