// Closed forms of the censored maximum likelihood.
#include "postprocess/laws/censored.hpp"

#include <cmath>

#include "coupling/base/require.hpp"

namespace clogflow::postprocess {
namespace {

/// Both laws are an exponential in a transformed duration u(x) >= 0: rate = complete / sum u.
template <class Transform>
CensoredFit exponential_rate(const std::vector<Observation>& sample, double xmin, const Transform& u) {
  require(std::isfinite(xmin) && xmin > 0, "xmin = {} (must be positive)", xmin);
  CensoredFit fit;
  for (const auto& [value, censored] : sample) {
    if (value < xmin) continue;
    fit.exposure += u(value);
    ++(censored ? fit.censored : fit.complete);
  }
  require(fit.complete > 0 && fit.exposure > 0,
          "no whole value above xmin = {} ({} censored ones): the law has no rate", xmin, fit.censored);
  fit.parameter = static_cast<double>(fit.complete) / fit.exposure;
  fit.sigma = fit.parameter / std::sqrt(static_cast<double>(fit.complete));
  return fit;
}

}  // namespace

double censored_exponent(double complete, double log_exposure) { return 1.0 + complete / log_exposure; }

CensoredFit fit_power_law_censored(const std::vector<Observation>& sample, double xmin) {
  CensoredFit fit = exponential_rate(sample, xmin, [&](double x) { return std::log(x / xmin); });
  fit.parameter = censored_exponent(static_cast<double>(fit.complete), fit.exposure);
  return fit;
}

CensoredFit fit_exponential_censored(const std::vector<Observation>& sample, double xmin) {
  return exponential_rate(sample, xmin, [&](double x) { return x - xmin; });
}

}  // namespace clogflow::postprocess
