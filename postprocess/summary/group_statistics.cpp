// Assembles the numbers of one ensemble.
#include "postprocess/summary/group_statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "coupling/base/content_hash.hpp"
#include "coupling/files/record_json.hpp"
#include "coupling/geometry/channel_geometry.hpp"
#include "coupling/scene/readable_scene.hpp"
#include "postprocess/summary/event_statistics.hpp"
#include "postprocess/summary/fit_json.hpp"
#include "postprocess/summary/quantities.hpp"

namespace clogflow::postprocess {
namespace {

using nlohmann::json;

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

/// An exponent alone says nothing: the law it belongs to goes with it.
void add_verdict(json& alpha, const json& fit) {
  for (const char* key : {"p_value", "ruled_out", "verdict"})
    if (fit.contains(key)) alpha[key] = fit.at(key);
}

json steady_state(const RunGroup& group, const StatisticsRequest& request) {
  const auto mean = [&](auto&& value) {
    const Estimate known = bootstrap_over_seeds(
        group.records.size(),
        [&](const std::vector<std::size_t>& drawn) {
          double sum = 0;
          for (const std::size_t k : drawn) sum += value(group.records[k].steady);
          return sum / static_cast<double>(drawn.size());
        },
        request.resampling);
    return as_json(is_spread_missing(known) ? without_interval(known) : known);
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
  if (shape["present"]) {
    const ChannelOutline outline = channel_outline(scene.geometry);
    for (const auto& [name, points] : {std::pair("upper", outline.upper), {"lower", outline.lower}})
      for (const Vec2& point : points) shape[name].push_back({point.x(), point.y()});
  }
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
    notes.push_back(
        "clogs are ended by releases: arrests are censored, alpha describes only those that end by "
        "themselves");
  }
  if (group.records.size() < 2) notes.push_back("a single seed: no intervals");
  return notes;
}

}  // namespace

json group_statistics(const RunGroup& group, const StatisticsRequest& request) {
  json runs = json::array();
  for (const SeedRecord& record : group.records) {
    runs.push_back({{"seed", record.seed},
                    {"file", std::filesystem::absolute(record.file).lexically_normal().string()},
                    {"start", record.window.start},
                    {"end", record.window.end},
                    {"filling_time", number_or_null(record.filling_time)},
                    {"wall_time", number_or_null(record.wall_time)},
                    {"passages", record.passages},
                    {"while_off", record.while_off},
                    {"releases", record.releases}});
  }
  json result{{"scene", readable_scene(group.scene_text)},
              {"scene_hash", content_hash(group.scene_text)},
              {"geometry", geometry(group.scene)},
              {"protocol", group.scene.unclog.protocol == UnclogProtocol::release ? "release" : "none"},
              {"tau", group.scale.tau},
              {"t_min", group.scale.threshold},
              {"runs", runs},
              {"quantities", quantities_with_halves(group, request)},
              {"bursts", burst_shape(group, request)},
              {"power_law", power_laws(group, request)},
              {"steady", steady_state(group, request)},
              {"provenance", record_json(group.record)},
              {"notes", notes(group)}};
  result.update(lapse_counts(group));
  add_verdict(result["quantities"]["alpha_fixed"], result["power_law"]["fixed_censored"]);
  return result;
}

}  // namespace clogflow::postprocess
