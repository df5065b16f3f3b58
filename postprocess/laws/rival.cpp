// Vuong's test.
#include "postprocess/laws/rival.hpp"

#include <cmath>

#include "coupling/base/require.hpp"
#include "postprocess/laws/hurwitz_zeta.hpp"

namespace clogflow::postprocess {
namespace {

/// \param difference of the log-likelihoods, one a value
RivalTest vuong(const std::vector<double>& difference, double rate) {
  RivalTest test;
  test.rate = rate;
  for (const double d : difference) test.log_ratio += d;
  const auto n = static_cast<double>(difference.size());
  double variance = 0;
  for (const double d : difference) variance += (d - test.log_ratio / n) * (d - test.log_ratio / n) / n;
  // Equal likelihoods point by point (one value): nothing distinguishes the laws, p stays 1.
  if (variance > 0) {
    test.normalized = test.log_ratio / std::sqrt(n * variance);
    test.p_value = std::erfc(std::abs(test.normalized) / std::sqrt(2.0));
  }
  return test;
}

}  // namespace

const char* favoured(const RivalTest& test) {
  if (test.p_value > 0.1) return "undecided";
  return test.log_ratio > 0.0 ? "power law" : "exponential";
}

RivalTest power_law_against_exponential(const std::vector<Observation>& sample, double xmin) {
  const double alpha = fit_power_law_censored(sample, xmin).parameter;
  const double rate = fit_exponential_censored(sample, xmin).parameter;
  std::vector<double> difference;
  for (const auto& [x, censored] : sample) {
    if (x < xmin) continue;
    const double power_survival = (1.0 - alpha) * std::log(x / xmin);
    const double exponential_survival = -rate * (x - xmin);
    const double power = power_survival + (censored ? 0.0 : std::log((alpha - 1.0) / x));
    const double exponential = exponential_survival + (censored ? 0.0 : std::log(rate));
    difference.push_back(power - exponential);
  }
  return vuong(difference, rate);
}

RivalTest discrete_power_law_against_exponential(const std::vector<double>& sample, double xmin, double alpha) {
  double excess = 0, count = 0;
  for (const double x : sample) {
    if (x < xmin) continue;
    excess += x - xmin;
    ++count;
  }
  require(excess > 0, "no value above xmin = {}: the exponential has no rate", xmin);
  const double rate = std::log1p(count / excess);
  const double log_norm = std::log(scaled_zeta(alpha, xmin).value);
  std::vector<double> difference;
  for (const double x : sample) {
    if (x < xmin) continue;
    const double power = -alpha * std::log(x / xmin) - log_norm;
    const double exponential = std::log(-std::expm1(-rate)) - rate * (x - xmin);
    difference.push_back(power - exponential);
  }
  return vuong(difference, rate);
}

}  // namespace clogflow::postprocess
