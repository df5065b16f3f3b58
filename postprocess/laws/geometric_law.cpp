// Kolmogorov-Smirnov distance with its distribution from simulated samples.
#include "postprocess/laws/geometric_law.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "coupling/base/random_stream.hpp"
#include "coupling/base/require.hpp"
#include "postprocess/laws/cutting_times.hpp"
#include "postprocess/laws/goodness_of_fit.hpp"
#include "postprocess/laws/hazard.hpp"
#include "postprocess/laws/parallel.hpp"
#include "postprocess/laws/survival.hpp"

namespace clogflow::postprocess {
namespace {

double share_of_ones(const std::vector<char>& values) {
  return static_cast<double>(std::accumulate(values.begin(), values.end(), std::size_t{0})) /
         static_cast<double>(values.size());
}

double mean_of(const std::vector<std::size_t>& sizes) {
  return std::accumulate(sizes.begin(), sizes.end(), 0.0) / static_cast<double>(sizes.size());
}

/// Both functions are steps at the whole numbers: it is enough to look at those that occur and just
/// before them.
double distance(const std::vector<std::size_t>& sizes) {
  std::vector<TrialCount> counts;
  counts.reserve(sizes.size());
  for (const std::size_t size : sizes) counts.push_back({size, true});
  const double go_on = 1.0 - 1.0 / mean_of(sizes);
  const auto below = [&](double s) { return 1.0 - std::pow(go_on, s); };
  const auto n = static_cast<double>(sizes.size());
  double largest = 0;
  std::size_t before = 0;
  for (const auto& [size, ended, cut] : ends_of(counts)) {
    const std::size_t up_to = before + ended;
    largest = std::max({largest, std::abs(static_cast<double>(up_to) / n - below(size)),
                        std::abs(static_cast<double>(before) / n - below(size - 1))});
    before = up_to;
  }
  return largest;
}

std::vector<std::size_t> geometric_sample(std::size_t n, double mean, RandomStream random) {
  const double log_go_on = std::log1p(-1.0 / mean);
  std::vector<std::size_t> sizes(n, 1);
  if (mean > 1)
    for (auto& s : sizes) s += static_cast<std::size_t>(std::log1p(-random.uniform()) / log_go_on);
  return sizes;
}

}  // namespace

GeometricTest test_geometric(const std::vector<std::size_t>& sizes, std::size_t replicates, std::uint64_t seed) {
  require(!sizes.empty() && replicates > 0, "{} burst sizes, {} replicates: nothing to test", sizes.size(), replicates);
  GeometricTest test;
  test.ks = distance(sizes);
  const double mean = mean_of(sizes);
  const auto far = on_all_cores(replicates, [&](std::size_t k) -> char {
    return distance(geometric_sample(sizes.size(), mean, RandomStream(seed, k))) >= test.ks ? 1 : 0;
  });
  test.p_value = share_of_ones(far);
  return test;
}

namespace {

double hazard_of(const TrialSums& sums) {
  return static_cast<double>(sums.events) / static_cast<double>(sums.events + sums.passed);
}

double distance(const std::vector<TrialCount>& sample) {
  const TrialSums sums = sums_of(sample);
  const double go_on = 1 - hazard_of(sums);
  const auto law = [&](double trials) { return std::pow(go_on, trials); };
  double before = 1, largest = 0;
  for (const SurvivalStep& step : kaplan_meier(ends_of(sample))) {
    largest = std::max({largest, std::abs(before - law(step.time)), std::abs(step.survival - law(step.time + 1))});
    before = step.survival;
  }
  // A survival function that ends with cut counts stays level while the law goes on falling.
  if (before > 0) largest = std::max(largest, std::abs(before - law(static_cast<double>(sums.largest))));
  return largest;
}

std::vector<TrialCount> cut_geometric_sample(std::size_t n, double hazard, const CuttingTimes& cut,
                                             RandomStream random) {
  std::vector<TrialCount> sample;
  sample.reserve(n);
  const double log_go_on = std::log1p(-hazard);
  for (std::size_t i = 0; i < n; ++i) {
    const double passed = hazard < 1 ? std::floor(std::log1p(-random.uniform()) / log_go_on) : 0;
    const double end = cut(random);  // half a trial before the one whose outcome is not seen
    sample.push_back(end < passed ? TrialCount{static_cast<std::size_t>(end + 0.5), false}
                                  : TrialCount{static_cast<std::size_t>(passed), true});
  }
  return sample;
}

}  // namespace

GeometricTest test_geometric_trials(const std::vector<TrialCount>& sample, std::size_t replicates, std::uint64_t seed) {
  const TrialSums sums = sums_of(sample);
  require(sums.events > 0 && replicates > 0, "{} counts that an event ended, {} replicates: nothing to test",
          sums.events, replicates);
  GeometricTest test;
  test.ks = distance(sample);
  const CuttingTimes cut(as_observations(sample));
  const auto far = on_all_cores(replicates, [&](std::size_t k) -> char {
    const auto made_up = cut_geometric_sample(sample.size(), hazard_of(sums), cut, RandomStream(seed, k));
    // Without an event there is no fit: it counts as far, which keeps the test lenient.
    return sums_of(made_up).events == 0 || distance(made_up) >= test.ks ? 1 : 0;
  });
  test.p_value = share_of_ones(far);
  return test;
}

std::optional<MemorylessTail> memoryless_tail(const std::vector<TrialCount>& sample, std::size_t fewest,
                                              std::size_t replicates, const Resampling& resampling) {
  for (std::size_t from = 0;; ++from) {
    std::vector<TrialCount> tail;
    for (const TrialCount& count : sample)
      if (trials_of(count) > from) tail.push_back({count.passed - from, count.ended});
    const std::size_t events = sums_of(tail).events;
    if (events == 0 || events < fewest) return {};
    const GeometricTest test = test_geometric_trials(tail, replicates, resampling.seed);
    if (test.p_value >= ruled_out_below)
      return MemorylessTail{from, events, test, hazard_per_trial(tail, resampling.level)};
  }
}

}  // namespace clogflow::postprocess
