// Product-limit estimator.
#include "postprocess/laws/survival.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace clogflow::postprocess {

std::vector<EndsAt> ends_of(std::vector<Observation> sample) {
  std::ranges::sort(sample, {}, &Observation::value);
  std::vector<EndsAt> ends;
  for (const Observation& each : sample) {
    if (ends.empty() || ends.back().time != each.value) ends.push_back({each.value, 0, 0});
    ++(each.censored ? ends.back().cut : ends.back().ended);
  }
  return ends;
}

std::vector<SurvivalStep> kaplan_meier(const std::vector<EndsAt>& ends) {
  std::size_t at_risk = 0;
  for (const EndsAt& each : ends) at_risk += each.ended + each.cut;
  std::vector<SurvivalStep> steps;
  double survival = 1;
  double greenwood = 0;
  for (const auto& [time, ended, cut] : ends) {
    if (ended > 0) {
      const auto n = static_cast<double>(at_risk);
      const auto d = static_cast<double>(ended);
      survival *= 1.0 - d / n;
      // When the last one at risk ends, S = 0 and its error is 0, not 0 times infinity.
      if (ended < at_risk) greenwood += d / (n * (n - d));
      steps.push_back({time, survival, survival * std::sqrt(greenwood), at_risk, ended});
    }
    at_risk -= ended + cut;
  }
  return steps;
}

std::vector<SurvivalStep> kaplan_meier(std::vector<Observation> sample) {
  return kaplan_meier(ends_of(std::move(sample)));
}

}  // namespace clogflow::postprocess
