// Semi-parametric bootstrap.
#include "postprocess/laws/goodness_of_fit.hpp"

#include <cmath>
#include <numeric>

#include "coupling/base/random_stream.hpp"
#include "coupling/base/require.hpp"
#include "postprocess/laws/parallel.hpp"
#include "postprocess/laws/pareto_tail.hpp"
#include "postprocess/laws/zeta_tail.hpp"

namespace clogflow::postprocess {
namespace {

template <class Variates>
std::vector<double> replicate(const SortedSample& sample, const PowerLawFit& fit, const Variates& variate,
                              RandomStream random) {
  const std::size_t below = fit.n - fit.n_tail;
  std::vector<double> values(fit.n);
  for (double& x : values) {
    x = random.below(fit.n) < below ? sample.value(random.below(below)) : variate(random);
  }
  return values;
}

bool is_as_far(const SortedSample& synthetic, const PowerLawFit& fit, LowerEnd lower_end) {
  if (lower_end == LowerEnd::scanned) return !some_tail_is_closer(synthetic, fit.ks);
  // A tail of fewer than two values says nothing about the law; counting it as far keeps the test
  // lenient.
  return !tail_is_closer(synthetic, fit.xmin, fit.ks);
}

template <class Variates>
double share_as_far(const SortedSample& sample, const PowerLawFit& fit, const Bootstrap& bootstrap) {
  const Variates variate(fit.alpha, fit.xmin);
  const auto far = on_all_cores(bootstrap.replicates, [&](std::size_t k) -> char {
    const SortedSample synthetic(replicate(sample, fit, variate, RandomStream(bootstrap.seed, k)), sample.kind());
    return is_as_far(synthetic, fit, bootstrap.lower_end) ? 1 : 0;
  });
  return static_cast<double>(std::accumulate(far.begin(), far.end(), std::size_t{0})) /
         static_cast<double>(bootstrap.replicates);
}

}  // namespace

double goodness_of_fit(const SortedSample& sample, const PowerLawFit& fit, const Bootstrap& bootstrap) {
  require(bootstrap.replicates > 0, "0 bootstrap replicates (a p-value needs at least one)");
  return sample.kind() == Values::whole ? share_as_far<ZetaVariates>(sample, fit, bootstrap)
                                        : share_as_far<ParetoVariates>(sample, fit, bootstrap);
}

std::string p_in_words(double p_value, std::size_t replicates) {
  if (p_value == 0) return fmt::format("p < {:.1g}", 1.0 / static_cast<double>(replicates));
  return fmt::format("p = {:.2g}", p_value);
}

double p_value_error(double p_value, std::size_t replicates) {
  return std::sqrt(p_value * (1.0 - p_value) / static_cast<double>(replicates));
}

}  // namespace clogflow::postprocess
