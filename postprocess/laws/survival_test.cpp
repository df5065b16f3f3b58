// Distances between steps and a curve, and samples of the curve.
#include "postprocess/laws/survival_test.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "coupling/base/random_stream.hpp"
#include "postprocess/laws/cutting_times.hpp"
#include "postprocess/laws/goodness_of_fit.hpp"
#include "postprocess/laws/parallel.hpp"
#include "postprocess/laws/pareto_tail.hpp"
#include "postprocess/laws/survival.hpp"

namespace clogflow::postprocess {
namespace {

std::vector<Observation> tail_of(const std::vector<Observation>& sample, double xmin) {
  std::vector<Observation> tail;
  std::ranges::copy_if(sample, std::back_inserter(tail), [&](const Observation& x) { return x.value >= xmin; });
  return tail;
}

SurvivalTest distance(const std::vector<Observation>& tail, double xmin) {
  const double alpha = fit_power_law_censored(tail, xmin).parameter;
  SurvivalTest test;
  double before = 1;
  for (const SurvivalStep& step : kaplan_meier(tail)) {
    const double law = std::pow(step.time / xmin, 1.0 - alpha);
    const double after = std::abs(step.survival - law);
    const double largest = std::max(after, std::abs(before - law));
    if (largest > test.ks) {
      test.ks = largest;
      test.at = step.time;
    }
    if (step.error > 0) test.standard_errors = std::max(test.standard_errors, after / step.error);
    before = step.survival;
  }
  return test;
}

}  // namespace

SurvivalTest test_survival(const std::vector<Observation>& sample, double xmin, std::size_t replicates,
                           std::uint64_t seed) {
  const auto tail = tail_of(sample, xmin);
  SurvivalTest test = distance(tail, xmin);
  if (replicates == 0) return test;
  const ParetoVariates variate(fit_power_law_censored(tail, xmin).parameter, xmin);
  const CuttingTimes cut(tail);
  const auto far = on_all_cores(replicates, [&](std::size_t k) -> char {
    RandomStream random(seed, k);
    std::vector<Observation> synthetic;
    bool has_whole = false;
    for (std::size_t i = 0; i < tail.size(); ++i) {
      const double whole = variate(random), end = cut(random);
      synthetic.push_back({std::min(whole, end), end < whole});
      has_whole |= !synthetic.back().censored;
    }
    // Without a whole value there is no fit: it counts as far, which keeps the test lenient.
    return !has_whole || distance(synthetic, xmin).ks >= test.ks ? 1 : 0;
  });
  test.p_value =
      static_cast<double>(std::accumulate(far.begin(), far.end(), std::size_t{0})) / static_cast<double>(replicates);
  test.p_error = p_value_error(test.p_value, replicates);
  return test;
}

}  // namespace clogflow::postprocess
