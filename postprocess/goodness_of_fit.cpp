// Semi-parametric bootstrap.
#include "postprocess/goodness_of_fit.hpp"

#include <cmath>
#include <numeric>

#include "coupling/require.hpp"
#include "postprocess/parallel.hpp"
#include "postprocess/random_stream.hpp"

namespace clog::postprocess {
namespace {

/// Inverse of F(x) = 1 - (x_min/x)^(alpha - 1).
double power_law_variate(const PowerLawFit& fit, double uniform) {
  return fit.xmin * std::pow(1.0 - uniform, -1.0 / (fit.alpha - 1.0));
}

std::vector<double> replicate(const SortedSample& sample, const PowerLawFit& fit,
                              RandomStream random) {
  const std::size_t below = fit.n - fit.n_tail;
  std::vector<double> values(fit.n);
  for (double& x : values) {
    x = random.below(fit.n) < below ? sample.value(random.below(below))
                                    : power_law_variate(fit, random.uniform());
  }
  return values;
}

bool is_as_far(const SortedSample& synthetic, const PowerLawFit& fit, LowerEnd lower_end) {
  if (lower_end == LowerEnd::scanned) return !some_tail_is_closer(synthetic, fit.ks);
  const std::size_t first = synthetic.lower_bound(fit.xmin);
  // A tail of fewer than two values says nothing about the law; counting it as far keeps the test
  // lenient.
  if (synthetic.size() - first < 2) return true;
  return KsDistance(synthetic).up_to(fit.ks, power_law_tail(synthetic, first, fit.xmin)) >= fit.ks;
}

}  // namespace

double goodness_of_fit(const SortedSample& sample, const PowerLawFit& fit,
                       const Bootstrap& bootstrap) {
  require(bootstrap.replicates > 0, "0 bootstrap replicates (a p-value needs at least one)");
  const auto far = on_all_cores(bootstrap.replicates, [&](std::size_t k) -> char {
    const SortedSample synthetic(replicate(sample, fit, RandomStream(bootstrap.seed, k)));
    return is_as_far(synthetic, fit, bootstrap.lower_end) ? 1 : 0;
  });
  return static_cast<double>(std::accumulate(far.begin(), far.end(), std::size_t{0})) /
         static_cast<double>(bootstrap.replicates);
}

double p_value_error(double p_value, std::size_t replicates) {
  return std::sqrt(p_value * (1.0 - p_value) / static_cast<double>(replicates));
}

}  // namespace clog::postprocess
