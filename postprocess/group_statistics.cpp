// Assembles the numbers of one ensemble.
#include "postprocess/group_statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "coupling/content_hash.hpp"
#include "postprocess/fit_json.hpp"
#include "postprocess/totals.hpp"

namespace clog::postprocess {
namespace {

using nlohmann::json;

json as_json(const Estimate& estimate) {
  return {{"value", number_or_null(estimate.value)},
          {"low", number_or_null(estimate.low)},
          {"high", number_or_null(estimate.high)}};
}

std::vector<std::array<Totals, 2>> halves_of(const RunGroup& group) {
  std::vector<std::array<Totals, 2>> halves;
  for (const SeedRecord& record : group.records) {
    const auto [start, end] = record.window;
    const double middle = 0.5 * (start + end);
    // The last passage may fall on the end itself.
    halves.push_back({totals_of(record, group.scale, {start, middle}),
                      totals_of(record, group.scale, {middle, std::nextafter(end, 2.0 * end)})});
  }
  return halves;
}

json quantities_with_halves(const RunGroup& group, const StatisticsRequest& request) {
  const auto halves = halves_of(group);
  std::vector<Totals> first, second, whole;
  for (const auto& [a, b] : halves) {
    first.push_back(a);
    second.push_back(b);
    whole.push_back(a + b);
    whole.back().seeds = 1;
  }
  json all = json::object();
  for (const Quantity& quantity : quantities()) {
    json entry = as_json(estimate(quantity, whole, request.resampling));
    entry["unit"] = quantity.unit;
    entry["meaning"] = quantity.meaning;
    const Estimate change = estimate_change(quantity, halves, request.resampling);
    entry["first_half"] = as_json(estimate(quantity, first, request.resampling));
    entry["second_half"] = as_json(estimate(quantity, second, request.resampling));
    entry["change"] = as_json(change);
    entry["ages"] = std::isfinite(change.low) ? json(change.low > 0 || change.high < 0) : json();
    all[quantity.key] = entry;
  }
  // What only the end of a run shows has no halves.
  for (const char* key : {"first_half", "second_half", "change", "ages"}) all["share_permanent"].erase(key);
  return all;
}

json burst_shape(const RunGroup& group) {
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
  return shape;
}

json fit_or_refusal(const std::vector<double>& lapses, const FitRequest& request, double tau) {
  if (lapses.empty()) return {{"refused", "no lapse longer than 0"}};
  const SortedSample sample(lapses);
  const std::string why_not = obstacle(sample, request.xmin);
  if (!why_not.empty()) return {{"refused", why_not}};
  json fit = fit_as_json(sample, request);
  fit["xmin_over_tau"] = fit["xmin"].get<double>() / tau;
  return fit;
}

json censored_fits(const RunGroup& group) {
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
  return {{"alpha", fit.parameter},
          {"sigma", fit.sigma},
          {"n_complete", fit.complete},
          {"n_censored", fit.censored},
          {"exponential", as_json(power_law_against_exponential(arrests, group.scale.threshold))}};
}

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
          {"fixed_censored", censored_fits(group)}};
}

json steady_state(const RunGroup& group, const StatisticsRequest& request) {
  const auto mean = [&](auto&& value) {
    return as_json(bootstrap_over_seeds(
        group.records.size(),
        [&](const std::vector<std::size_t>& drawn) {
          double sum = 0;
          for (const std::size_t k : drawn) sum += value(group.records[k].steady);
          return sum / static_cast<double>(drawn.size());
        },
        request.resampling));
  };
  json steady{{"particles", mean([](const SteadyState& s) { return s.particles; })},
              {"packing_fraction", mean([](const SteadyState& s) { return s.packing_fraction; })},
              {"porosity", json::array()}};
  for (std::size_t strip = 0; strip < group.records.front().steady.porosity.size(); ++strip) {
    steady["porosity"].push_back(mean([&](const SteadyState& s) {
      return strip < s.porosity.size() ? s.porosity[strip] : std::numeric_limits<double>::quiet_NaN();
    }));
  }
  return steady;
}

json geometry(const Scene& scene) {
  json shape{{"neck_width", scene.geometry.neck_width},
             {"neck_height", scene.geometry.neck_height},
             {"channel_width", scene.geometry.channel_width},
             {"channel_length", scene.geometry.channel_length},
             {"neck_length", scene.geometry.neck_length},
             {"half_angle", scene.geometry.half_angle},
             {"present", scene.geometry.present && scene.geometry.stl.empty()},
             {"passage_plane", scene.passages.plane},
             {"mean_velocity", scene.flow.mean_velocity},
             {"diameter", scene.particles.diameter}};
  if (scene.geometry.neck_width > 0) {
    shape["neck_ratio"] = scene.geometry.neck_width / scene.particles.diameter;
  }
  return shape;
}

json notes(const RunGroup& group) {
  json notes = json::array();
  if (group.scene.contact.torsion_update == TorsionUpdate::doubling) {
    notes.push_back("contact.torsion_update = \"doubling\": an experiment, the springs are not objective");
  }
  if (group.scene.drag.fluctuation.strength > 0) notes.push_back("drag.fluctuation is on");
  if (group.scene.flow.pulsation.strength > 0) notes.push_back("flow.pulsation is on");
  if (group.scene.unclog.protocol == UnclogProtocol::release) {
    notes.push_back("clogs are ended by releases: arrests are censored, alpha describes only those that end by themselves");
  }
  if (group.records.size() < 2) notes.push_back("a single seed: no intervals");
  return notes;
}

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

json group_statistics(const RunGroup& group, const StatisticsRequest& request) {
  json runs = json::array();
  for (const SeedRecord& record : group.records) {
    runs.push_back({{"seed", record.seed},
                    {"file", std::filesystem::absolute(record.file).lexically_normal().string()},
                    {"start", record.window.start},
                    {"end", record.window.end},
                    {"filling_time", record.filling_time},
                    {"passages", record.passages},
                    {"while_off", record.while_off},
                    {"releases", record.releases}});
  }
  json result{{"scene", group.scene_text},
              {"scene_hash", content_hash(group.scene_text)},
              {"geometry", geometry(group.scene)},
              {"protocol", group.scene.unclog.protocol == UnclogProtocol::release ? "release" : "none"},
              {"tau", group.scale.tau},
              {"t_min", group.scale.threshold},
              {"runs", runs},
              {"quantities", quantities_with_halves(group, request)},
              {"bursts", burst_shape(group)},
              {"power_law", power_laws(group, request)},
              {"steady", steady_state(group, request)},
              {"provenance", group.provenance},
              {"notes", notes(group)}};
  result.update(lapse_counts(group));
  return result;
}

}  // namespace clog::postprocess
