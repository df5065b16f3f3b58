// Percentile bootstrap.
#include "postprocess/laws/confidence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "coupling/base/quantile.hpp"
#include "coupling/base/random_stream.hpp"

namespace clogflow::postprocess {

Estimate bootstrap_over_seeds(std::size_t count, const EnsembleStatistic& statistic, const Resampling& resampling) {
  std::vector<std::size_t> seeds(count);
  std::iota(seeds.begin(), seeds.end(), std::size_t{0});
  constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
  Estimate estimate{statistic(seeds), undefined, undefined};
  if (!std::isfinite(estimate.value)) return estimate;
  if (count < 2) {
    estimate.note = "a single seed: no interval";
    return estimate;
  }

  std::vector<double> values;
  for (std::size_t replicate = 0; replicate < resampling.replicates; ++replicate) {
    RandomStream random(resampling.seed, replicate);
    for (auto& seed : seeds) seed = random.below(count);
    const double value = statistic(seeds);
    if (std::isfinite(value)) values.push_back(value);
  }
  if (2 * values.size() < resampling.replicates || values.empty()) {
    estimate.note = "few seeds define it: no interval";
    return estimate;
  }
  std::sort(values.begin(), values.end());
  estimate.low = interpolated_quantile(values, (1.0 - resampling.level) / 2.0);
  estimate.high = interpolated_quantile(values, (1.0 + resampling.level) / 2.0);
  return estimate;
}

bool is_spread_missing(const Estimate& estimate) {
  // Sums in another order differ in their last digits.
  constexpr double rounding = 1e-12;
  return estimate.high - estimate.low <= rounding * std::abs(estimate.value);
}

Estimate without_interval(const Estimate& estimate) {
  constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
  return {estimate.value, undefined, undefined, "resampled seeds all agree"};
}

Estimate mean_over_seeds(const std::vector<double>& values, const Resampling& resampling) {
  const Estimate mean = bootstrap_over_seeds(
      values.size(),
      [&](const std::vector<std::size_t>& drawn) {
        double sum = 0;
        for (const std::size_t k : drawn) sum += values[k];
        return sum / static_cast<double>(drawn.size());
      },
      resampling);
  return is_spread_missing(mean) ? without_interval(mean) : mean;
}

}  // namespace clogflow::postprocess
