// clog info: what a scene, a flow file or a run file holds, in words.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/info_json.hpp"
#include "cli/output.hpp"
#include "cli/verbs.hpp"
#include "coupling/base/content_hash.hpp"
#include "coupling/base/publish_file.hpp"
#include "coupling/base/require.hpp"
#include "coupling/base/shown_text.hpp"
#include "coupling/files/flow_grid.hpp"
#include "coupling/files/hdf5_file.hpp"
#include "coupling/files/record_json.hpp"
#include "coupling/files/run_file.hpp"
#include "coupling/files/run_pack.hpp"
#include "coupling/scene/readable_scene.hpp"
#include "coupling/scene/scene.hpp"

namespace clogflow::cli {
namespace {

struct InfoOptions {
  std::filesystem::path file, out;
  Overrides overrides;
  bool effective = false;
  bool flow_hash = false;
  bool flow_inputs = false;
};

/// Lengths for a reader's eye; files and memory hold metres.
std::string micrometres(double length) { return fmt::format("{:.4g} um", 1e6 * length); }

void print_record(const nlohmann::json& record) {
  for (const auto& [key, value] : record.items()) {
    constexpr std::size_t longest = 100;
    print_result("  {}: {}\n", shown_text(key, longest),
                 shown_text(value.is_string() ? value.get<std::string>() : value.dump(), longest));
  }
}

void print_scene(const std::string& effective) {
  const std::string text = readable_scene(effective);
  constexpr std::size_t longest = 1000;  // the seeds may be many
  print_result("made for this scene:\n");
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    print_result("  {}\n", shown_text(std::string_view(text).substr(at, end - at), longest));
    at = end + 1;
  }
}

void print_flow(const FlowGrid& grid, const std::string& name) {
  const auto& n = grid.points;
  const Vec3 last = grid.origin + grid.spacing * Vec3(n[0] - 1, n[1] - 1, n[2] - 1);
  print_result("{}: a flow file: the velocity of the undisturbed fluid on a regular grid\n", name);
  print_result("grid: {} x {} x {} points, {} apart\n", n[0], n[1], n[2], micrometres(grid.spacing));
  for (int axis = 0; axis < 3; ++axis)
    print_result("  {} from {} to {}\n", "xyz"[axis], micrometres(grid.origin[axis]), micrometres(last[axis]));
  print_result("fluid at {:.1f} % of the points; fastest {:.4g} mm/s\n", 100 * fluid_share(grid), 1e3 * fastest(grid));
  print_result("walls: {} triangles\nhash: {}\nwhere it comes from:\n", grid.walls.size(), shown_text(grid.hash));
  print_record(record_json(grid.record));
  print_scene(grid.scene_text);
}

void print_run(const RunData& run, const std::string& name) {
  print_result("{}: a run file: what the particles of seed {} did in {:.6g} s\n", name, run.seed, run.end_time);
  print_result("passages: {}", run.passages.time.size());
  if (!run.passages.time.empty()) {
    const auto off = std::ranges::count(run.passages.friction_off, std::uint8_t{1});
    print_result(", from {:.6g} s to {:.6g} s, {} of them while friction was off", run.passages.time.front(),
                 run.passages.time.back(), off);
  }
  print_result("\nreleases of a clog: {}\n", run.releases.off.size());
  print_result("time series: {} samples", run.series.time.size());
  if (!run.series.time.empty())
    print_result("; at the end {} particles, packing fraction {:.3f}, {} contacts, {} with walls",
                 run.series.count.back(), run.series.packing_fraction.back(), run.series.contacts.back(),
                 run.series.wall_contacts.back());
  print_result("\nsnapshots: {}", run.snapshots.size());
  if (!run.snapshots.empty())
    print_result(", the last at {:.6g} s with {} particles", run.snapshots.back().time, run.snapshots.back().id.size());
  print_result("\nwhere it comes from:\n");
  print_record(record_json(run.record));
  print_scene(run.scene_text);
}

void print_pack(const std::filesystem::path& pack) {
  const std::vector<std::filesystem::path> runs = runs_in_pack(pack);
  print_result("{}: a pack of {} run file{}, {} to {}\n", pack.string(), runs.size(), runs.size() == 1 ? "" : "s",
               shown_text(runs.front().filename().string()), shown_text(runs.back().filename().string()));
  print_result("clog stats takes it as a folder; of one run: clog info {}\nthe first was ", runs.front().string());
  print_scene(read_run_head(runs.front()).scene_text);
}

void print_scene_file(const InfoOptions& options) {
  const Scene scene = read_scene(options.file, options.overrides);
  const bool solved = scene.flow.source == FlowSource::openfoam;
  const std::string hash = solved ? content_hash(flow_inputs(scene)) : "";
  if (options.flow_hash) {
    if (solved) print_data("{}\n", hash);
  } else if (options.flow_inputs) {
    print_data("{}", flow_inputs(scene));
  } else if (options.effective) {
    const std::string text = readable_scene(effective_scene(scene));
    if (!options.out.empty()) return publish_file(text, options.out);
    print_data("{}", text);
  } else if (json_wanted()) {
    print_json(info_json(scene, options.file.string(), hash));
  } else {
    print_result("{}: a scene: particles of {} for {:.6g} s, {} seeds\n", options.file.string(),
                 micrometres(scene.particles.diameter), scene.time.end, scene.ensemble.seeds.size());
    if (solved) print_result("flow: OpenFOAM, hash {}\n", hash);
    print_result("with every default filled in:\n{}", readable_scene(effective_scene(scene)));
  }
}

void print_info(const InfoOptions& options) {
  require(!json_wanted() || !(options.effective || options.flow_hash || options.flow_inputs),
          "--json (gives the whole scene: leave out --effective, --flow-hash and --flow-inputs)");
  require(options.out.empty() || options.effective, "--out {} (goes with --effective only)", options.out.string());
  if (options.file.extension() == ".toml") return print_scene_file(options);
  require(options.overrides.empty() && !options.effective && !options.flow_hash && !options.flow_inputs,
          "{} (--set, --effective, --flow-hash and --flow-inputs are for scene files, *.toml)", options.file.string());
  const FileFormat format = file_format(options.file);
  const std::string name = options.file.string();
  if (format.name == "clogflow flow") {
    const FlowGrid flow = read_flow_grid(options.file);
    return json_wanted() ? print_json(info_json(flow, name)) : print_flow(flow, name);
  }
  if (format.name == "clogflow run") {
    const RunData run = read_run_file(options.file);
    return json_wanted() ? print_json(info_json(run, name)) : print_run(run, name);
  }
  if (format.name == pack_format.name)
    return json_wanted() ? print_json(pack_info_json(options.file)) : print_pack(options.file);
  require(!json_wanted(), "--json {} (a \"{}\" file: scenes, flows, runs and packs can be told in JSON)", name,
          shown_text(format.name));
  print_result("{}: a \"{}\" file, version {}\n", name, shown_text(format.name), format.version);
}

}  // namespace

void add_info(CLI::App& app) {
  auto* verb = app.add_subcommand("info", "what a flow file, a run file, a pack or a scene holds, in words");
  auto options = std::make_shared<InfoOptions>();
  verb->add_option("file", options->file, "FILE.h5, PACK.h5/run_0001.h5, or a scene")->required();
  verb->add_option("--set", options->overrides, "key=value: overrides the scene")->allow_extra_args(false);
  verb->add_flag("--effective", options->effective, "of a scene: only the complete scene, as TOML");
  verb->add_option("--out", options->out, "with --effective: the file to write it to");
  verb->add_flag("--flow-inputs", options->flow_inputs, "of a scene: only what decides its flow");
  verb->add_flag("--flow-hash", options->flow_hash, "of a scene: only the name of its flow");
  verb->callback([options] { print_info(*options); });
}

}  // namespace clogflow::cli
