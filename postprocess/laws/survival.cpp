// Product-limit estimator.
#include "postprocess/laws/survival.hpp"

#include <algorithm>
#include <cmath>

namespace clogflow::postprocess {

std::vector<SurvivalStep> kaplan_meier(std::vector<Observation> sample) {
  std::sort(sample.begin(), sample.end(), [](const Observation& a, const Observation& b) {
    return a.value < b.value || (a.value == b.value && a.censored < b.censored);
  });
  std::vector<SurvivalStep> steps;
  double survival = 1;
  double greenwood = 0;
  for (std::size_t i = 0; i < sample.size();) {
    const std::size_t at_risk = sample.size() - i;
    const double time = sample[i].value;
    std::size_t ended = 0;
    for (; i < sample.size() && sample[i].value == time; ++i) ended += sample[i].censored ? 0 : 1;
    if (ended == 0) continue;
    const auto n = static_cast<double>(at_risk);
    const auto d = static_cast<double>(ended);
    survival *= 1.0 - d / n;
    // When the last one at risk ends, S = 0 and its error is 0, not 0 times infinity.
    if (ended < at_risk) greenwood += d / (n * (n - d));
    steps.push_back({time, survival, survival * std::sqrt(greenwood), at_risk, ended});
  }
  return steps;
}

}  // namespace clogflow::postprocess
