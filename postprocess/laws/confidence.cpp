// Percentile bootstrap.
#include "postprocess/laws/confidence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "coupling/base/quantile.hpp"
#include "coupling/base/random_stream.hpp"
#include "postprocess/laws/parallel.hpp"

namespace clogflow::postprocess {

namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

/// Below so many draws threads take longer to begin than the work.
constexpr std::size_t draws_for_threads = 1'000'000;

}  // namespace

void draw_seeds(std::size_t count, const Resampling& resampling,
                const std::function<void(std::size_t, const std::vector<std::size_t>&)>& take) {
  const auto draw = [&](std::size_t replicate) {
    thread_local std::vector<std::size_t> seeds;
    seeds.resize(count);
    RandomStream random(resampling.seed, replicate);
    for (auto& seed : seeds) seed = random.below(count);
    take(replicate, seeds);
    return char{};
  };
  if (count * resampling.replicates < draws_for_threads)
    for (std::size_t replicate = 0; replicate < resampling.replicates; ++replicate) draw(replicate);
  else
    on_all_cores(resampling.replicates, draw);
}

Estimate percentile_interval(double value, const std::vector<double>& replicates, const Resampling& resampling) {
  Estimate estimate{value, not_known, not_known};
  std::vector<double> values;
  for (const double each : replicates)
    if (std::isfinite(each)) values.push_back(each);
  if (2 * values.size() < resampling.replicates || values.empty()) {
    estimate.note = "few seeds define it: no interval";
    return estimate;
  }
  std::sort(values.begin(), values.end());
  estimate.low = interpolated_quantile(values, (1.0 - resampling.level) / 2.0);
  estimate.high = interpolated_quantile(values, (1.0 + resampling.level) / 2.0);
  return estimate;
}

Estimate bootstrap_over_seeds(std::size_t count, const EnsembleStatistic& statistic, const Resampling& resampling) {
  std::vector<std::size_t> seeds(count);
  std::iota(seeds.begin(), seeds.end(), std::size_t{0});
  const double value = statistic(seeds);
  if (!std::isfinite(value)) return {value, not_known, not_known};
  if (count < 2) return single_seed(value);
  std::vector<double> replicates(resampling.replicates);
  draw_seeds(count, resampling, [&](std::size_t replicate, const std::vector<std::size_t>& drawn) {
    replicates[replicate] = statistic(drawn);
  });
  return percentile_interval(value, replicates, resampling);
}

bool is_spread_missing(const Estimate& estimate) {
  // Sums in another order differ in their last digits.
  constexpr double rounding = 1e-12;
  return estimate.high - estimate.low <= rounding * std::abs(estimate.value);
}

Estimate single_seed(double value) { return {value, not_known, not_known, "a single seed: no interval"}; }

Estimate without_interval(const Estimate& estimate) {
  return {estimate.value, not_known, not_known, "resampled seeds all agree"};
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
