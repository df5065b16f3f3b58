// The numbers of every ensemble, with what was run.
#include "postprocess/output/statistics_json.hpp"

#include <filesystem>

#include "coupling/base/content_hash.hpp"
#include "coupling/files/record_json.hpp"
#include "coupling/scene/readable_scene.hpp"
#include "postprocess/events/sweep_axis.hpp"
#include "postprocess/output/first_burst_json.hpp"
#include "postprocess/output/fit_json.hpp"
#include "postprocess/output/shape_json.hpp"
#include "postprocess/output/trend_json.hpp"

namespace clogflow::postprocess {
namespace {

using nlohmann::json;

constexpr int statistics_version = 1;

/// Of every key that is not a pure number, wherever it stands.
const json units{{"tau", "s"},
                 {"t_min", "s"},
                 {"longest", "s"},
                 {"xmin", "s"},
                 {"largest_miss_at", "s"},
                 {"rate", "1/s"},
                 {"start", "s"},
                 {"end", "s"},
                 {"filling_time", "s"},
                 {"wall_time", "s"},
                 {"neck_width", "m"},
                 {"neck_height", "m"},
                 {"channel_width", "m"},
                 {"channel_length", "m"},
                 {"neck_length", "m"},
                 {"half_angle", "rad"},
                 {"passage_plane", "m"},
                 {"upper", "m"},
                 {"lower", "m"},
                 {"fluid", "m"},
                 {"walls", "m"},
                 {"diameter", "m"},
                 {"feed_diameter", "m"},
                 {"passage_diameter", "m"},
                 {"density", "kg/m3"},
                 {"mean_velocity", "m/s"}};

json as_json(const SeedRecord& record) {
  return {{"seed", record.seed},
          {"file", std::filesystem::absolute(record.file).lexically_normal().string()},
          {"start", record.window.start},
          {"end", record.window.end},
          {"filling_time", number_or_null(record.filling_time)},
          {"wall_time", number_or_null(record.wall_time)},
          {"passages", record.passages},
          {"while_off", record.while_off},
          {"releases", record.releases}};
}

json as_json(const QuantityStatistics& statistics) {
  json entry = as_json(statistics.whole);
  entry["unit"] = statistics.quantity->unit;
  entry["meaning"] = statistics.quantity->meaning;
  if (!statistics.halves) return entry;
  entry["first_half"] = as_json(statistics.halves->first_half);
  entry["second_half"] = as_json(statistics.halves->second_half);
  entry["change"] = as_json(statistics.halves->change);
  entry["drifts"] = statistics.halves->drifts ? json(*statistics.halves->drifts) : json();
  return entry;
}

json as_json(const BurstShape& bursts) {
  json shape{{"counted", bursts.counted}, {"first", bursts.first}, {"cut_off", bursts.cut_off}};
  if (!bursts.spread) return shape;
  const BurstSpread& spread = *bursts.spread;
  shape.update({{"largest", spread.largest},
                {"standard_deviation", spread.standard_deviation},
                {"standard_deviation_geometric", spread.standard_deviation_geometric},
                {"share_up_to_3", spread.share_up_to_3},
                {"share_up_to_3_geometric", spread.share_up_to_3_geometric},
                {"geometric",
                 {{"ks", spread.geometric.ks},
                  {"p_value", spread.geometric.p_value},
                  {"ruled_out", spread.verdict.ruled_out},
                  {"verdict", spread.verdict.words}}}});
  return shape;
}

json as_json(const CountsByEnd& counts) {
  return {{"ended_by_passage", counts.passage},
          {"ended_by_release", counts.release},
          {"ended_by_end_of_run", counts.end_of_run}};
}

json as_json(const FitOrRefusal<TailFit>& outcome, double tau) {
  if (const auto* refusal = std::get_if<Refusal>(&outcome)) return {{"refused", refusal->why}};
  const auto& fit = std::get<TailFit>(outcome);
  json result = as_json(fit);
  result["xmin_over_tau"] = fit.law.xmin / tau;
  return result;
}

json as_json(const FitOrRefusal<ArrestFit>& outcome) {
  if (const auto* refusal = std::get_if<Refusal>(&outcome)) return {{"refused", refusal->why}};
  return as_json(std::get<ArrestFit>(outcome));
}

json as_json(const SteadyStatistics& statistics) {
  json steady{{"particles", as_json(statistics.particles)},
              {"packing_fraction", as_json(statistics.packing_fraction)},
              {"porosity", json::array()}};
  for (const Estimate& strip : statistics.porosity) steady["porosity"].push_back(as_json(strip));
  return steady;
}

json as_json(const SizeStatistics& sizes) {
  json all{{"feed_diameter", sizes.feed_diameter},
           {"feed_spread", sizes.feed_spread},
           {"passage_diameter", as_json(sizes.passage_diameter)},
           {"species", json::array()}};
  for (const SpeciesStatistics& each : sizes.species)
    all["species"].push_back({{"diameter", each.diameter},
                              {"density", each.density},
                              {"feed_share", each.feed_share},
                              {"passages", each.passages},
                              {"passage_share", as_json(each.passage_share)}});
  return all;
}

/// Of one neck of several: what it alone let pass.
json neck_json(const std::vector<SeedRecord>& records, const GroupStatistics& numbers) {
  json runs = json::array(), quantities = json::object();
  for (const SeedRecord& record : records)
    runs.push_back({{"seed", record.seed}, {"passages", record.passages}, {"while_off", record.while_off}});
  for (const QuantityStatistics& each : numbers.quantities) quantities[each.quantity->key] = as_json(each);
  return {{"runs", runs},
          {"quantities", quantities},
          {"first_burst", as_json(numbers.first_burst)},
          {"bursts", as_json(numbers.bursts)},
          {"lapses", as_json(numbers.lapses.lapses)},
          {"arrests", as_json(numbers.lapses.arrests)},
          {"longest", numbers.lapses.longest}};
}

json as_json(const RunGroup& group, const GroupStatistics& numbers) {
  json runs = json::array(), quantities = json::object();
  for (const SeedRecord& record : group.records) runs.push_back(as_json(record));
  for (const QuantityStatistics& each : numbers.quantities) quantities[each.quantity->key] = as_json(each);
  // An exponent alone says nothing: the verdict on the law that it belongs to goes with it.
  const PowerLaws& laws = numbers.power_laws;
  if (const auto* fit = std::get_if<ArrestFit>(&laws.fixed_censored))
    quantities["alpha_fixed"].update(verdict_json(*fit));
  json lapses = as_json(numbers.lapses.lapses);
  lapses["zero"] = numbers.lapses.zero;
  json entry{{"label", numbers.label},
             {"scene", readable_scene(group.scene_text)},
             {"scene_hash", content_hash(group.scene_text)},
             {"geometry", shape_json(group.scene)},
             {"protocol", key_value(group.lines, "unclog.protocol").text},
             {"tau", group.scale.tau},
             {"t_min", group.scale.threshold},
             {"runs", runs},
             {"quantities", quantities},
             {"first_burst", as_json(numbers.first_burst)},
             {"burst_order", numbers.burst_order ? as_json(*numbers.burst_order) : json()},
             {"bursts", as_json(numbers.bursts)},
             {"lapses", lapses},
             {"arrests", as_json(numbers.lapses.arrests)},
             {"longest", numbers.lapses.longest},
             {"power_law",
              {{"free", as_json(laws.free, group.scale.tau)},
               {"fixed", as_json(laws.fixed, group.scale.tau)},
               {"fixed_censored", as_json(laws.fixed_censored)}}},
             {"steady", as_json(numbers.steady)},
             {"provenance", record_json(group.record)},
             {"notes", numbers.notes}};
  for (std::size_t k = 0; k < group.necks.size(); ++k)
    entry["necks"].push_back(neck_json(group.necks[k], numbers.necks[k]));
  if (numbers.sizes) entry["sizes"] = as_json(*numbers.sizes);
  return entry;
}

}  // namespace

json as_json(const Statistics& statistics) {
  json all{{"format", "clogflow statistics"},
           {"version", statistics_version},
           {"program", CLOG_VERSION},
           {"units", units},
           {"sweep", statistics.swept_keys},
           {"confidence", statistics.resampling.level},
           {"bootstrap_seed", statistics.resampling.seed},
           {"groups", json::array()},
           {"trend", as_json(statistics.trend)}};
  for (std::size_t i = 0; i < statistics.groups.size(); ++i)
    all["groups"].push_back(as_json(statistics.groups[i], statistics.numbers[i]));
  all["trend"]["without_runs"] = statistics.without_runs;
  return all;
}

}  // namespace clogflow::postprocess
