// Shape of the burst distribution, fits to the lapses, and what ended them.
#include "postprocess/summary/event_statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "postprocess/laws/geometric_law.hpp"
#include "postprocess/laws/survival_test.hpp"
#include "postprocess/summary/fit_json.hpp"

namespace clogflow::postprocess {

using nlohmann::json;

namespace {

constexpr std::size_t geometric_replicates = 1000;  // p to 0.016 at most

}  // namespace

std::vector<std::size_t> counted_burst_sizes(const RunGroup& group) {
  std::vector<std::size_t> sizes;
  for (const SeedRecord& record : group.records) {
    const bool by_release = record.protocol == UnclogProtocol::release;
    for (const Burst& burst : record.bursts) {
      const bool counts = burst.kind == BurstKind::whole || (burst.kind == BurstKind::first && !by_release);
      if (counts && burst.size > 0) sizes.push_back(burst.size);
    }
  }
  return sizes;
}

std::vector<double> whole_lapses(const RunGroup& group) {
  std::vector<double> durations;
  for (const SeedRecord& record : group.records) {
    for (const Lapse& lapse : record.lapses) {
      if (lapse.end == LapseEnd::passage) durations.push_back(lapse.duration);
    }
  }
  return durations;
}

json burst_shape(const RunGroup& group, const StatisticsRequest& request) {
  std::size_t first = 0, cut_off = 0;
  for (const SeedRecord& record : group.records) {
    for (const Burst& burst : record.bursts) {
      first += burst.kind == BurstKind::first ? 1 : 0;
      cut_off += burst.kind == BurstKind::cut_off ? 1 : 0;
    }
  }
  const auto sizes = counted_burst_sizes(group);
  json shape{{"counted", sizes.size()}, {"first", first}, {"cut_off", cut_off}};
  if (sizes.empty()) return shape;
  const auto n = static_cast<double>(sizes.size());
  double mean = 0, square = 0, small = 0;
  for (const std::size_t s : sizes) {
    mean += static_cast<double>(s) / n;
    square += static_cast<double>(s * s) / n;
    small += s <= 3 ? 1.0 / n : 0.0;
  }
  const double deviation = std::sqrt(std::max(0.0, square - mean * mean));
  shape["largest"] = *std::max_element(sizes.begin(), sizes.end());
  shape["standard_deviation"] = deviation;
  // A geometric law (memoryless stopping) has deviation sqrt(m (m - 1)) and this share of s <= 3.
  shape["standard_deviation_geometric"] = std::sqrt(mean * (mean - 1.0));
  shape["share_up_to_3"] = small;
  shape["share_up_to_3_geometric"] = 1.0 - std::pow(1.0 - 1.0 / mean, 3);
  const GeometricTest test = test_geometric(sizes, geometric_replicates, request.resampling.seed);
  const bool ruled_out = test.p_value < ruled_out_below;
  shape["geometric"] = {{"ks", test.ks},
                        {"p_value", test.p_value},
                        {"ruled_out", ruled_out},
                        {"verdict", fmt::format("{} ({})", ruled_out ? "ruled out" : "not ruled out",
                                                p_in_words(test.p_value, geometric_replicates))}};
  return shape;
}

namespace {

json fit_or_refusal(const std::vector<double>& lapses, const FitRequest& request, double tau) {
  if (lapses.empty()) return {{"refused", "no lapse longer than 0"}};
  const SortedSample sample(lapses, Values::continuous);
  const std::string why_not = obstacle(sample, request.xmin);
  if (!why_not.empty()) return {{"refused", why_not}};
  json fit = fit_as_json(sample, request);
  fit["xmin_over_tau"] = fit["xmin"].get<double>() / tau;
  return fit;
}

/// Whether the law meets the survival function of the arrests that it was fitted to, in words too.
json held_against_survival(const std::vector<Observation>& arrests, const ClogScale& scale,
                           const StatisticsRequest& request) {
  const SurvivalTest test =
      test_survival(arrests, scale.threshold, request.p_value_replicates, request.resampling.seed);
  const std::string miss =
      fmt::format("misses the survival curve of the arrests by up to {:.1f} standard errors, most at {:.3g} tau",
                  test.standard_errors, test.at / scale.tau);
  json result{{"ks", test.ks}, {"largest_miss_at", test.at}, {"standard_errors", test.standard_errors}};
  if (request.p_value_replicates == 0) {
    result["verdict"] = "not tested: " + miss;
    return result;
  }
  const std::string p = p_in_words(test.p_value, request.p_value_replicates);
  const bool ruled_out = test.p_value < ruled_out_below;
  result["p_value"] = test.p_value;
  result["p_value_error"] = test.p_error;
  result["p_value_replicates"] = request.p_value_replicates;
  result["ruled_out"] = ruled_out;
  result["verdict"] =
      ruled_out ? fmt::format("power law ruled out ({}): {}", p, miss) : fmt::format("power law not ruled out ({})", p);
  return result;
}

json censored_fits(const RunGroup& group, const StatisticsRequest& request) {
  std::vector<Observation> arrests;
  bool has_whole = false;
  for (const SeedRecord& record : group.records) {
    for (const Lapse& lapse : arrests_of(record.lapses, group.scale.threshold)) {
      arrests.push_back(as_observation(lapse));
      has_whole |= !arrests.back().censored && lapse.duration > group.scale.threshold;
    }
  }
  if (!has_whole) return {{"refused", "no arrest that ended with a passage"}};
  const CensoredFit fit = fit_power_law_censored(arrests, group.scale.threshold);
  json result{{"alpha", fit.parameter},
              {"sigma", fit.sigma},
              {"n_complete", fit.complete},
              {"n_censored", fit.censored},
              {"exponential", as_json(power_law_against_exponential(arrests, group.scale.threshold))}};
  result.update(held_against_survival(arrests, group.scale, request));
  return result;
}

}  // namespace

json lapse_counts(const RunGroup& group) {
  std::size_t zero = 0;
  double longest = 0;
  std::array<std::size_t, 3> lapses{}, arrests{};
  for (const SeedRecord& record : group.records) {
    for (const Lapse& lapse : record.lapses) {
      const auto end = static_cast<std::size_t>(lapse.end);
      ++lapses[end];
      arrests[end] += lapse.duration >= group.scale.threshold ? 1 : 0;
      zero += lapse.duration == 0 ? 1 : 0;
      longest = std::max(longest, lapse.duration);
    }
  }
  const auto by_end = [](const std::array<std::size_t, 3>& n) {
    return json{{"ended_by_passage", n[0]}, {"ended_by_release", n[1]}, {"ended_by_end_of_run", n[2]}};
  };
  json counts{{"lapses", by_end(lapses)}, {"arrests", by_end(arrests)}, {"longest", longest}};
  counts["lapses"]["zero"] = zero;
  return counts;
}

json power_laws(const RunGroup& group, const StatisticsRequest& request) {
  std::vector<double> lapses = whole_lapses(group);
  std::erase(lapses, 0.0);
  FitRequest fit{.xmin = {}, .p_value = {}, .seed = request.resampling.seed};
  if (request.p_value_replicates > 0) fit.p_value = request.p_value_replicates;
  FitRequest fixed = fit;
  fixed.xmin = group.scale.threshold;
  return {{"free", fit_or_refusal(lapses, fit, group.scale.tau)},
          {"fixed", fit_or_refusal(lapses, fixed, group.scale.tau)},
          {"fixed_censored", censored_fits(group, request)}};
}

}  // namespace clogflow::postprocess
