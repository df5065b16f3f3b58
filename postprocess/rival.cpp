// Vuong's test.
#include "postprocess/rival.hpp"

#include <cmath>

namespace clog::postprocess {

RivalTest power_law_against_exponential(const std::vector<Observation>& sample, double xmin) {
  const double alpha = fit_power_law_censored(sample, xmin).parameter;
  RivalTest test;
  test.rate = fit_exponential_censored(sample, xmin).parameter;
  std::vector<double> difference;
  for (const auto& [x, censored] : sample) {
    if (x < xmin) continue;
    const double power_survival = (1.0 - alpha) * std::log(x / xmin);
    const double exponential_survival = -test.rate * (x - xmin);
    const double power = power_survival + (censored ? 0.0 : std::log((alpha - 1.0) / x));
    const double exponential = exponential_survival + (censored ? 0.0 : std::log(test.rate));
    difference.push_back(power - exponential);
    test.log_ratio += difference.back();
  }
  const auto n = static_cast<double>(difference.size());
  double variance = 0;
  for (const double d : difference)
    variance += (d - test.log_ratio / n) * (d - test.log_ratio / n) / n;
  // Equal likelihoods point by point (one value): nothing distinguishes the laws, p stays 1.
  if (variance > 0) {
    test.normalized = test.log_ratio / std::sqrt(n * variance);
    test.p_value = std::erfc(std::abs(test.normalized) / std::sqrt(2.0));
  }
  return test;
}

}  // namespace clog::postprocess
