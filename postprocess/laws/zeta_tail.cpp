// Likelihood and distribution functions through the Hurwitz zeta function.
#include "postprocess/laws/zeta_tail.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include <boost/math/tools/roots.hpp>

#include "postprocess/laws/hurwitz_zeta.hpp"

namespace clogflow::postprocess {
namespace {

constexpr std::size_t table_length = 1024;
constexpr int digits = 48;  // of the exponent, binary

/// Mean and variance of ln(X/x_min).
struct LogarithmMoments {
  double mean = 0, variance = 0;
};

LogarithmMoments moments(double alpha, double xmin) {
  const ScaledZeta z = scaled_zeta(alpha, xmin);
  const double mean = -z.slope / z.value;
  return {mean, z.curvature / z.value - mean * mean};
}

}  // namespace

double zeta_survival(double alpha, double xmin, double x) {
  return std::pow(x / xmin, -alpha) * scaled_zeta(alpha, x).value / scaled_zeta(alpha, xmin).value;
}

double zeta_exponent(double mean_logarithm, double xmin) {
  if (!(mean_logarithm > 0)) return std::numeric_limits<double>::infinity();
  // The mean is below that of the continuous law, 1/(alpha - 1), and near that of one that starts
  // at x_min - 1/2, Eq. (3.7).
  const double largest = 1.0 + 1.0 / mean_logarithm;
  const double guess = 1.0 + 1.0 / (mean_logarithm + std::log(xmin / (xmin - 0.5)));
  const auto excess = [&](double alpha) {
    const LogarithmMoments m = moments(alpha, xmin);
    return std::tuple(std::log(mean_logarithm / m.mean), m.variance / m.mean);
  };
  std::uintmax_t steps = 200;
  return boost::math::tools::newton_raphson_iterate(excess, guess, 1.0, largest, digits, steps);
}

ZetaTail ZetaTail::of(const SortedSample& sample, std::size_t first, double xmin) {
  const auto n = static_cast<double>(sample.size() - first);
  const auto& distinct = sample.distinct();
  ZetaTail tail;
  tail.first = first;
  tail.first_distinct =
      static_cast<std::size_t>(std::lower_bound(distinct.begin(), distinct.end(), first) - distinct.begin());
  tail.xmin = xmin;
  const bool one_value = sample.value(sample.size() - 1) == xmin;
  tail.alpha = zeta_exponent(one_value ? 0.0 : sample.sum_of_logarithms(first) / n - std::log(xmin), xmin);
  if (std::isfinite(tail.alpha)) tail.norm = scaled_zeta(tail.alpha, xmin).value;
  return tail;
}

PointRange ZetaTail::points(const SortedSample& sample) const { return {first_distinct, sample.distinct().size() - 1}; }

LawAt ZetaTail::law_at(const SortedSample& sample, std::size_t k) const {
  const std::size_t i = sample.distinct()[k];
  const double probability = std::exp(-alpha * (sample.logarithm(i) - std::log(xmin))) / norm;
  const double reached = probability * scaled_zeta(alpha, sample.value(i)).value;
  return {1.0 - reached, 1.0 - (reached - probability)};
}

double ZetaTail::share_below(const SortedSample& sample, std::size_t k) const {
  const auto& distinct = sample.distinct();
  return sample.share_before(first, k < distinct.size() ? distinct[k] : sample.size());
}

double ZetaTail::deviation(const SortedSample& sample, std::size_t k, const LawAt& law) const {
  return std::max(std::abs(law.before - share_below(sample, k)), std::abs(law.at - share_below(sample, k + 1)));
}

double ZetaTail::bound(const SortedSample& sample, std::size_t k, const LawAt& law_k, std::size_t l,
                       const LawAt& law_l) const {
  return std::max(law_l.before - share_below(sample, k + 1), share_below(sample, l) - law_k.at);
}

double ZetaTail::sigma(const SortedSample& sample) const {
  const auto n = static_cast<double>(sample.size() - first);
  return 1.0 / std::sqrt(n * moments(alpha, xmin).variance);
}

ZetaVariates::ZetaVariates(double alpha, double xmin) : alpha_(alpha), xmin_(xmin) {
  const double norm = scaled_zeta(alpha, xmin).value;
  double survival = 1.0;
  for (std::size_t k = 0; k < table_length; ++k) {
    survival_.push_back(survival);
    survival -= std::exp(-alpha * std::log1p(static_cast<double>(k) / xmin)) / norm;
  }
}

double ZetaVariates::operator()(RandomStream& random) const {
  const double u = 1.0 - random.uniform();
  if (survival_.back() >= u) return beyond_table(u);
  const auto above =
      std::partition_point(survival_.begin(), survival_.end(), [&](double survival) { return survival >= u; });
  return xmin_ + static_cast<double>(above - survival_.begin() - 1);
}

double ZetaVariates::beyond_table(double u) const {
  constexpr double largest = std::numeric_limits<double>::max() / 2;
  double low = xmin_ + static_cast<double>(table_length - 1), high = 2.0 * low;
  while (high < largest && zeta_survival(alpha_, xmin_, high) >= u) {
    low = high;
    high *= 2.0;
  }
  while (high - low > 1.0) {
    const double middle = std::floor(low + 0.5 * (high - low));
    if (middle == low || middle == high) break;  // neighbours among the numbers of this size
    (zeta_survival(alpha_, xmin_, middle) >= u ? low : high) = middle;
  }
  return low;
}

}  // namespace clogflow::postprocess
