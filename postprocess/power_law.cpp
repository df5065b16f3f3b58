// The exponent of a tail, and the scan for x_min.
#include "postprocess/power_law.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "coupling/require.hpp"

namespace clog::postprocess {
namespace {

/// A first look at some candidates brings the best distance down, so that nearly all others are
/// refused by their first few points.
constexpr std::size_t first_looks = 64;

struct Candidate {
  double distance = std::numeric_limits<double>::infinity();
  std::size_t first = 0;
};

PowerLawTail tail_at(const SortedSample& sample, std::size_t first) {
  return power_law_tail(sample, first, sample.value(first));
}

/// Values that differ by rounding only leave no exponent; such a tail is no candidate.
bool has_exponent(const PowerLawTail& tail) {
  return std::isfinite(tail.alpha) && tail.alpha > 1.0;
}

PowerLawFit described(const SortedSample& sample, const PowerLawTail& tail, double xmin) {
  PowerLawFit fit;
  fit.n = sample.size();
  fit.n_tail = sample.size() - tail.first;
  fit.alpha = tail.alpha;
  fit.sigma = (tail.alpha - 1.0) / std::sqrt(static_cast<double>(fit.n_tail));
  fit.xmin = xmin;
  fit.ks = ks_distance_all_points(sample, tail);
  return fit;
}

}  // namespace

PowerLawTail power_law_tail(const SortedSample& sample, std::size_t first, double xmin) {
  const auto n = static_cast<double>(sample.size() - first);
  const double log_xmin = std::log(xmin);
  return {first, log_xmin, 1.0 + n / (sample.sum_of_logarithms(first) - n * log_xmin)};
}

std::string obstacle(const SortedSample& sample, std::optional<double> xmin) {
  const double largest = sample.value(sample.size() - 1);
  if (!xmin) {
    if (sample.size() < smallest_sample) {
      return fmt::format("{} values (a fit needs at least {})", sample.size(), smallest_sample);
    }
    if (!has_exponent(tail_at(sample, 0))) {
      return fmt::format("all {} values equal {} (no power law describes them)", sample.size(),
                         largest);
    }
    return {};
  }
  if (!std::isfinite(*xmin) || *xmin <= 0)
    return fmt::format("xmin = {} (must be positive)", *xmin);
  const std::size_t first = sample.lower_bound(*xmin);
  if (sample.size() - first < 2) {
    return fmt::format(
        "xmin = {} leaves {} of {} values (a power law needs two or more); the largest is {}",
        *xmin, sample.size() - first, sample.size(), largest);
  }
  if (!has_exponent(power_law_tail(sample, first, *xmin))) {
    return fmt::format("all values from xmin = {} on equal it (no power law describes them)",
                       *xmin);
  }
  return {};
}

PowerLawFit fit_power_law(const SortedSample& sample, double xmin) {
  const std::string why_not = obstacle(sample, xmin);
  require(why_not.empty(), "{}", why_not);
  return described(sample, power_law_tail(sample, sample.lower_bound(xmin), xmin), xmin);
}

PowerLawFit fit_power_law(const SortedSample& sample) {
  const std::string why_not = obstacle(sample, {});
  require(why_not.empty(), "{}", why_not);
  const auto& distinct = sample.distinct();
  const std::size_t candidates = distinct.size() - 1;
  KsDistance distance(sample);
  Candidate best;
  const auto look_at = [&](std::size_t first) {
    const PowerLawTail tail = tail_at(sample, first);
    if (!has_exponent(tail)) return;
    const double d = distance.up_to(best.distance, tail);
    if (d < best.distance || (d == best.distance && first < best.first)) best = {d, first};
  };
  for (std::size_t k = 0; k < first_looks; ++k) look_at(distinct[candidates * k / first_looks]);
  for (std::size_t k = 0; k < candidates; ++k) look_at(distinct[k]);
  return described(sample, tail_at(sample, best.first), sample.value(best.first));
}

bool some_tail_is_closer(const SortedSample& sample, double limit) {
  const auto& distinct = sample.distinct();
  const std::size_t candidates = distinct.size() - 1;
  KsDistance distance(sample);
  // A stride through all candidates meets a close one early, wherever it is. With a stride that is
  // coprime to the number of candidates each is visited once.
  std::size_t stride =
      static_cast<std::size_t>(static_cast<double>(candidates) / std::numbers::phi);
  if (stride == 0) stride = 1;
  while (std::gcd(stride, candidates) != 1) ++stride;
  for (std::size_t k = 0, at = 0; k < candidates; ++k, at = (at + stride) % candidates) {
    const PowerLawTail tail = tail_at(sample, distinct[at]);
    if (has_exponent(tail) && distance.up_to(limit, tail) < limit) return true;
  }
  return false;
}

}  // namespace clog::postprocess
