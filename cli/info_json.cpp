#include "cli/info_json.hpp"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "cli/json_parts.hpp"
#include "coupling/files/record_json.hpp"
#include "coupling/files/run_pack.hpp"

namespace clogflow::cli {

using nlohmann::json;

double fastest(const FlowGrid& grid) {
  double most = 0;
  for (std::size_t i = 0; i + 2 < grid.velocity.size(); i += 3)
    most = std::max(most, std::hypot(double{grid.velocity[i]}, grid.velocity[i + 1], grid.velocity[i + 2]));
  return most;
}

double fluid_share(const FlowGrid& grid) {
  const auto solid = std::ranges::count(grid.solid, std::uint8_t{1});
  return 1 - static_cast<double>(solid) / static_cast<double>(grid.solid.size());
}

json info_json(const Scene& scene, const std::string& file, const std::string& flow_hash) {
  json all = json_head("info of a scene");
  all.update({{"file", file},
              {"seeds", scene.ensemble.seeds.size()},
              {"flow_hash", flow_hash.empty() ? json() : json(flow_hash)},
              {"scene", scene_json(effective_scene(scene))}});
  return all;
}

json info_json(const FlowGrid& grid, const std::string& file) {
  json all = json_head("info of a flow");
  all.update({{"file", file},
              {"points", grid.points},
              {"spacing_m", grid.spacing},
              {"origin_m", {grid.origin[0], grid.origin[1], grid.origin[2]}},
              {"fluid_share", fluid_share(grid)},
              {"fastest_m_s", fastest(grid)},
              {"wall_triangles", grid.walls.size()},
              {"hash", grid.hash},
              {"provenance", record_json(grid.record)},
              {"scene", scene_json(grid.scene_text)}});
  return all;
}

json info_json(const RunData& run, const std::string& file) {
  const auto& times = run.passages.time;
  const auto& series = run.series;
  json all = json_head("info of a run");
  all.update({{"file", file},
              {"seed", run.seed},
              {"simulated_s", run.end_time},
              {"passages", times.size()},
              {"passages_friction_off", std::ranges::count(run.passages.friction_off, std::uint8_t{1})},
              {"first_passage_s", times.empty() ? json() : json(times.front())},
              {"last_passage_s", times.empty() ? json() : json(times.back())},
              {"releases", run.releases.off.size()},
              {"series_rows", series.time.size()},
              {"snapshots", run.snapshots.size()},
              {"last_snapshot_s", run.snapshots.empty() ? json() : json(run.snapshots.back().time)},
              {"provenance", record_json(run.record)},
              {"scene", scene_json(run.scene_text)}});
  all["at_end"] = nullptr;
  if (!series.time.empty())
    all["at_end"] = {{"particles", series.count.back()},
                     {"packing_fraction", number_or_null(series.packing_fraction.back())},
                     {"contacts", series.contacts.back()},
                     {"wall_contacts", series.wall_contacts.back()}};
  return all;
}

json pack_info_json(const std::filesystem::path& pack) {
  json all = json_head("info of a pack");
  json names = json::array();
  const auto runs = runs_in_pack(pack);
  for (const auto& run : runs) names.push_back(run.filename().string());
  all.update({{"file", pack.string()}, {"runs", names}, {"scene", scene_json(read_run_head(runs.front()).scene_text)}});
  return all;
}

}  // namespace clogflow::cli
