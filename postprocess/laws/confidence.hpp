// Confidence by resampling the seeds: passages within a run are not independent, runs are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace clogflow::postprocess {

/// A value with the interval in which it lies with 95 % confidence.
struct Estimate {
  double value = 0;
  double low = 0, high = 0;  ///< percentile interval; NaN where it cannot be given
  std::string note = {};     ///< why something is missing, or where the interval comes from instead
};

struct Resampling {
  std::size_t replicates = 2000;
  std::uint64_t seed = 1;
  double level = 0.95;  ///< [-]
};

/// Statistic of an ensemble in which seed k occurs as often as its index occurs.
/// May return NaN when that ensemble does not define it. Called on many threads at once.
using EnsembleStatistic = std::function<double(const std::vector<std::size_t>& seeds)>;

/// Percentile bootstrap over seeds: `count` seeds are drawn with replacement. Replicates in which
/// the statistic is undefined are left out; fewer than 2 seeds, or half the replicates undefined:
/// no interval. With few seeds (< 10) such intervals are a little too narrow. \source Efron &
/// Tibshirani, An Introduction to the Bootstrap, ch. 13
Estimate bootstrap_over_seeds(std::size_t count, const EnsembleStatistic& statistic, const Resampling& resampling);

/// Calls take(replicate, seeds drawn) for each replicate of bootstrap_over_seeds, on all cores and in any order.
/// \param take  must not throw, nor change what another replicate's call sees
void draw_seeds(std::size_t count, const Resampling& resampling,
                const std::function<void(std::size_t, const std::vector<std::size_t>&)>& take);

/// The interval of bootstrap_over_seeds around the value of the ensemble itself. \param replicates  values of the
/// resampled ensembles, in order, undefined ones included
Estimate percentile_interval(double value, const std::vector<double>& replicates, const Resampling& resampling);

/// Whether all resampled ensembles gave the same value: seeds that happen to agree have no spread,
/// which does not make the value certain.
bool is_spread_missing(const Estimate& estimate);

/// The value alone, of an ensemble that cannot be resampled.
Estimate single_seed(double value);

/// The value alone, and why.
Estimate without_interval(const Estimate& estimate);

/// Mean of one value a seed; the value alone where the seeds agree. \param values  not empty
Estimate mean_over_seeds(const std::vector<double>& values, const Resampling& resampling);

}  // namespace clogflow::postprocess
