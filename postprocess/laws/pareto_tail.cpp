// Closed forms.
#include "postprocess/laws/pareto_tail.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace clogflow::postprocess {

ParetoTail ParetoTail::of(const SortedSample& sample, std::size_t first, double xmin) {
  const auto n = static_cast<double>(sample.size() - first);
  const double log_xmin = std::log(xmin);
  return {first, log_xmin, 1.0 + n / (sample.sum_of_logarithms(first) - n * log_xmin)};
}

LawAt ParetoTail::law_at(const SortedSample& sample, std::size_t i) const {
  const double f = 1.0 - std::exp((alpha - 1.0) * (log_xmin - sample.logarithm(i)));
  return {f, f};
}

double ParetoTail::deviation(const SortedSample& sample, std::size_t i, const LawAt& law) const {
  return std::abs(law.at - sample.share_before(first, i));
}

double ParetoTail::bound(const SortedSample& sample, std::size_t i, const LawAt& law_i, std::size_t j,
                         const LawAt& law_j) const {
  return std::max(law_j.at - sample.share_before(first, i + 1), sample.share_before(first, j - 1) - law_i.at);
}

double ParetoTail::sigma(const SortedSample& sample) const {
  return (alpha - 1.0) / std::sqrt(static_cast<double>(sample.size() - first));
}

double ParetoVariates::operator()(RandomStream& random) const {
  const double x = xmin_ * std::pow(1.0 - random.uniform(), -1.0 / (alpha_ - 1.0));
  // An exponent near 1 reaches beyond the range of numbers.
  return std::min(x, std::numeric_limits<double>::max());
}

}  // namespace clogflow::postprocess
