#include "postprocess/laws/tail_fit.hpp"

#include <vector>

namespace clogflow::postprocess {
namespace {

RivalTest against_exponential(const SortedSample& sample, const PowerLawFit& fit) {
  if (sample.kind() == Values::whole) {
    std::vector<double> tail;
    for (std::size_t i = sample.lower_bound(fit.xmin); i < sample.size(); ++i) tail.push_back(sample.value(i));
    return discrete_power_law_against_exponential(tail, fit.xmin, fit.alpha);
  }
  std::vector<Observation> tail;
  for (std::size_t i = sample.lower_bound(fit.xmin); i < sample.size(); ++i) tail.push_back({sample.value(i), false});
  return power_law_against_exponential(tail, fit.xmin);
}

}  // namespace

TailFit fit_tail(const SortedSample& sample, const FitRequest& request) {
  const PowerLawFit law = request.xmin ? fit_power_law(sample, *request.xmin) : fit_power_law(sample);
  TailFit fit{
      .law = law,
      .kind = sample.kind(),
      .exponential = against_exponential(sample, law),
      .bootstrap = {request.p_value_replicates, request.seed, request.xmin ? LowerEnd::fixed : LowerEnd::scanned},
      .p_value = {}};
  if (request.p_value_replicates > 0) fit.p_value = goodness_of_fit(sample, law, fit.bootstrap);
  return fit;
}

}  // namespace clogflow::postprocess
