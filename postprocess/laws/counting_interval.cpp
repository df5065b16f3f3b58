// Quantiles of the beta and gamma distributions behind the exact intervals.
#include "postprocess/laws/counting_interval.hpp"

#include <cmath>
#include <limits>

#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/gamma.hpp>

#include "coupling/base/require.hpp"

namespace clogflow::postprocess {
namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

}  // namespace

Estimate mean_burst_from_counts(std::size_t stops, std::size_t passages, double level) {
  require(stops <= passages, "{} bursts with {} passages (a burst has at least one)", stops, passages);
  if (passages == 0) return {undefined, undefined, undefined};
  const auto n = static_cast<double>(stops), of = static_cast<double>(passages);
  if (stops == 0) return {undefined, -1.0 / std::expm1(std::log1p(-level) / of), undefined};
  const double tail = 0.5 * (1 - level);
  using boost::math::beta_distribution;
  const double rare = quantile(beta_distribution(n, of - n + 1), tail);
  const double often = stops == passages ? 1.0 : quantile(complement(beta_distribution(n + 1, of - n), tail));
  return {of / n, 1 / often, 1 / rare};
}

Estimate share_from_counts(std::size_t part, std::size_t whole, double level) {
  require(part <= whole, "{} of {}: no share", part, whole);
  if (whole == 0) return {undefined, undefined, undefined};
  const auto k = static_cast<double>(part), n = static_cast<double>(whole);
  const double bound = std::pow(1 - level, 1 / n);
  if (part == 0) return {0, 0, 1 - bound};
  if (part == whole) return {1, bound, 1};
  const double tail = 0.5 * (1 - level);
  using boost::math::beta_distribution;
  return {k / n, quantile(beta_distribution(k, n - k + 1), tail),
          quantile(complement(beta_distribution(k + 1, n - k), tail))};
}

Estimate rate_from_counts(std::size_t events, double exposure, double level) {
  if (!(exposure > 0)) return {undefined, undefined, undefined};
  if (events == 0) return {0, 0, -std::log1p(-level) / exposure};
  const auto n = static_cast<double>(events);
  const double tail = 0.5 * (1 - level);
  using boost::math::gamma_distribution;
  return {n / exposure, quantile(gamma_distribution(n), tail) / exposure,
          quantile(complement(gamma_distribution(n + 1), tail)) / exposure};
}

Estimate wider(const Estimate& a, const Estimate& b) {
  return {a.value, std::fmin(a.low, b.low), std::fmax(a.high, b.high), a.note};
}

}  // namespace clogflow::postprocess
