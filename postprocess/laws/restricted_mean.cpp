#include "postprocess/laws/restricted_mean.hpp"

#include <cmath>
#include <limits>

#include "postprocess/laws/hazard.hpp"
#include "postprocess/laws/survival.hpp"

namespace clogflow::postprocess {

double restricted_mean(const std::vector<TrialCount>& sample, std::size_t up_to) {
  double area = 0, survival = 1;
  std::size_t from = 0;
  for (const SurvivalStep& step : kaplan_meier(as_observations(sample))) {
    const auto trial = static_cast<std::size_t>(step.time);
    if (trial >= up_to) break;
    area += survival * static_cast<double>(trial - from);
    from = trial;
    survival = step.survival;
  }
  return area + survival * static_cast<double>(up_to - from);
}

MeanCount mean_count(const std::vector<TrialCount>& sample, const Resampling& resampling) {
  constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
  const TrialSums sums = sums_of(sample);
  const Estimate memoryless = mean_of_hazard(hazard_per_trial(sample, resampling.level));
  if (sums.events == 0)
    return {{undefined, memoryless.low, undefined, "no event: bound of a law without memory"}, sums.largest};
  MeanCount result{.mean = {}, .up_to = sums.largest};
  result.is_restricted = kaplan_meier(as_observations(sample)).back().survival > 0;
  result.mean = bootstrap_over_seeds(
      sample.size(),
      [&](const std::vector<std::size_t>& drawn) {
        std::vector<TrialCount> again;
        for (const std::size_t k : drawn) again.push_back(sample[k]);
        return restricted_mean(again, sums.largest);
      },
      resampling);
  if (!std::isfinite(result.mean.low) || !is_spread_missing(result.mean)) return result;
  const std::string why = without_interval(result.mean).note;
  result.mean = {result.mean.value, memoryless.low, memoryless.high, why + "; interval of the counts"};
  return result;
}

}  // namespace clogflow::postprocess
