// The exponent of a tail, and the scan for x_min.
#include "postprocess/laws/power_law.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "coupling/base/require.hpp"
#include "postprocess/laws/ks_distance.hpp"
#include "postprocess/laws/pareto_tail.hpp"
#include "postprocess/laws/zeta_tail.hpp"

namespace clogflow::postprocess {
namespace {

/// A first look at some candidates brings the best distance down, so that nearly all others are
/// refused by their first few points.
constexpr std::size_t first_looks = 64;

struct Candidate {
  double distance = std::numeric_limits<double>::infinity();
  std::size_t first = 0;
};

template <class Tail>
Tail tail_at(const SortedSample& sample, std::size_t first) {
  return Tail::of(sample, first, sample.value(first));
}

/// Values that differ by rounding only leave no exponent; such a tail is no candidate.
template <class Tail>
bool has_exponent(const Tail& tail) {
  return std::isfinite(tail.alpha) && tail.alpha > 1.0;
}

template <class Tail>
PowerLawFit described(const SortedSample& sample, const Tail& tail, double xmin) {
  PowerLawFit fit;
  fit.n = sample.size();
  fit.n_tail = sample.size() - tail.first;
  fit.alpha = tail.alpha;
  fit.sigma = tail.sigma(sample);
  fit.xmin = xmin;
  fit.ks = ks_distance_all_points(sample, tail);
  return fit;
}

/// Calls work with the kind of tail that the sample has.
template <class Work>
auto with_tail(const SortedSample& sample, const Work& work) {
  return sample.kind() == Values::whole ? work(ZetaTail()) : work(ParetoTail());
}

template <class Tail>
PowerLawFit scan(const SortedSample& sample) {
  const auto& distinct = sample.distinct();
  const std::size_t candidates = distinct.size() - 1;
  KsDistance<Tail> distance(sample);
  Candidate best;
  const auto look_at = [&](std::size_t first) {
    const Tail tail = tail_at<Tail>(sample, first);
    if (!has_exponent(tail)) return;
    const double d = distance.up_to(best.distance, tail);
    if (d < best.distance || (d == best.distance && first < best.first)) best = {d, first};
  };
  for (std::size_t k = 0; k < first_looks; ++k) look_at(distinct[candidates * k / first_looks]);
  for (std::size_t k = 0; k < candidates; ++k) look_at(distinct[k]);
  return described(sample, tail_at<Tail>(sample, best.first), sample.value(best.first));
}

template <class Tail>
bool some_is_closer(const SortedSample& sample, double limit) {
  const auto& distinct = sample.distinct();
  const std::size_t candidates = distinct.size() - 1;
  KsDistance<Tail> distance(sample);
  // A stride through all candidates meets a close one early, wherever it is. With a stride that is
  // coprime to the number of candidates each is visited once.
  std::size_t stride = static_cast<std::size_t>(static_cast<double>(candidates) / std::numbers::phi);
  if (stride == 0) stride = 1;
  while (std::gcd(stride, candidates) != 1) ++stride;
  for (std::size_t k = 0, at = 0; k < candidates; ++k, at = (at + stride) % candidates) {
    const Tail tail = tail_at<Tail>(sample, distinct[at]);
    if (has_exponent(tail) && distance.up_to(limit, tail) < limit) return true;
  }
  return false;
}

/// Equal whole numbers have the law of infinite exponent, which they meet exactly; equal continuous
/// values have none.
bool limit_law_is_closer(const SortedSample& sample, double limit) {
  return sample.kind() == Values::whole && limit > 0;
}

std::string obstacle_of_xmin(const SortedSample& sample, double xmin) {
  if (!std::isfinite(xmin) || xmin <= 0) return fmt::format("xmin = {} (must be positive)", xmin);
  if (sample.kind() == Values::whole && std::floor(xmin) != xmin)
    return fmt::format("xmin = {} (must be whole, as the values are)", xmin);
  const std::size_t first = sample.lower_bound(xmin);
  const double largest = sample.value(sample.size() - 1);
  if (sample.size() - first < 2) {
    return fmt::format("xmin = {} leaves {} of {} values (a power law needs two or more); the largest is {}", xmin,
                       sample.size() - first, sample.size(), largest);
  }
  const bool has_one = with_tail(sample, [&]<class Tail>(Tail) { return has_exponent(Tail::of(sample, first, xmin)); });
  if (largest == xmin || !has_one) {
    return fmt::format("all values from xmin = {} on equal it (no power law describes them)", xmin);
  }
  return {};
}

}  // namespace

const char* rule_for_ties(Values kind) {
  return kind == Values::whole ? "discrete law: both distribution functions are compared at every whole number"
                               : "as Clauset's plfit: the empirical distribution climbs i/n (i = 0 ... n_tail - 1) "
                                 "through equal values";
}

std::string obstacle(const SortedSample& sample, std::optional<double> xmin) {
  if (xmin) return obstacle_of_xmin(sample, *xmin);
  if (sample.size() < smallest_sample) {
    return fmt::format("{} values (a fit needs at least {})", sample.size(), smallest_sample);
  }
  const bool has_one = with_tail(sample, [&]<class Tail>(Tail) { return has_exponent(tail_at<Tail>(sample, 0)); });
  if (sample.distinct().size() < 2 || !has_one) {
    return fmt::format("all {} values equal {} (no power law describes them)", sample.size(),
                       sample.value(sample.size() - 1));
  }
  return {};
}

PowerLawFit fit_power_law(const SortedSample& sample, double xmin) {
  const std::string why_not = obstacle(sample, xmin);
  require(why_not.empty(), "{}", why_not);
  return with_tail(sample, [&]<class Tail>(Tail) {
    return described(sample, Tail::of(sample, sample.lower_bound(xmin), xmin), xmin);
  });
}

PowerLawFit fit_power_law(const SortedSample& sample) {
  const std::string why_not = obstacle(sample, {});
  require(why_not.empty(), "{}", why_not);
  return with_tail(sample, [&]<class Tail>(Tail) { return scan<Tail>(sample); });
}

bool some_tail_is_closer(const SortedSample& sample, double limit) {
  if (sample.distinct().size() < 2) return limit_law_is_closer(sample, limit);
  return with_tail(sample, [&]<class Tail>(Tail) { return some_is_closer<Tail>(sample, limit); });
}

bool tail_is_closer(const SortedSample& sample, double xmin, double limit) {
  const std::size_t first = sample.lower_bound(xmin);
  if (sample.size() - first < 2) return false;
  return with_tail(sample, [&]<class Tail>(Tail) {
    const Tail tail = Tail::of(sample, first, xmin);
    if (!has_exponent(tail)) return limit_law_is_closer(sample, limit);
    return KsDistance<Tail>(sample).up_to(limit, tail) < limit;
  });
}

}  // namespace clogflow::postprocess
