// clog export: a run or a flow for ParaView and OVITO.
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "cli/output.hpp"
#include "cli/verbs.hpp"
#include "coupling/base/require.hpp"
#include "coupling/base/shown_text.hpp"
#include "coupling/files/hdf5_file.hpp"
#include "coupling/scene/scene.hpp"
#include "dem/run/model_walls.hpp"
#include "postprocess/output/export_files.hpp"

namespace clogflow::cli {
namespace {

namespace fs = std::filesystem;
using postprocess::ExportFormat;

struct ExportOptions {
  fs::path file, out, flow;
  std::string format = "all";
  bool no_walls = false;

  bool wants(ExportFormat which) const { return format == "all" || (format == "vtk") == (which == ExportFormat::vtk); }
};

void say_file(const fs::path& file) { print_result("{}\n", file.string()); }

/// Those that the particles meet, from the scene in the run file; of a channel from a file those of the flow.
Walls walls_of(const RunData& run, const ExportOptions& options, const FlowGrid* flow) {
  if (options.no_walls) return {};
  try {
    Model model;
    model.scene = parse_scene(run.scene_text, options.file.string());
    build_walls(model, flow);
    return model.walls;
  } catch (const Error& error) {
    throw Error(fmt::format("{} (the walls of the run: --no-walls leaves them out)", error.what()));
  }
}

void export_run(const ExportOptions& options) {
  const RunData run = read_run_file(options.file);
  std::optional<FlowGrid> flow;
  if (!options.flow.empty()) {
    flow = read_flow_grid(options.flow);
    require(!run.record.flow_hash || flow->hash == *run.record.flow_hash,
            "--flow {}: not the flow of this run (hash {}; the run's is {})", options.flow.string(),
            shown_text(flow->hash), shown_text(run.record.flow_hash.value_or("")));
  }
  const Walls walls = walls_of(run, options, flow ? &*flow : nullptr);
  const std::string name = options.file.stem().string();
  for (const ExportFormat format : {ExportFormat::vtk, ExportFormat::xyz})
    if (options.wants(format)) say_file(postprocess::export_run(run, name, walls, format, options.out));
  if (!options.wants(ExportFormat::vtk)) return;
  if (!walls.empty()) say_file(postprocess::export_walls(walls, options.out));
  if (flow) say_file(postprocess::export_flow(*flow, options.flow.stem().string(), options.out));
  say_file(postprocess::export_macro(options.out));
}

void export_flow(const ExportOptions& options) {
  require(options.wants(ExportFormat::vtk), "{}: a flow has no particles for --format xyz (OVITO): give a run file",
          options.file.string());
  require(options.flow.empty(), "--flow {} (goes with a run file; {} is a flow itself)", options.flow.string(),
          options.file.string());
  const FlowGrid flow = read_flow_grid(options.file);
  say_file(postprocess::export_flow(flow, options.file.stem().string(), options.out));
  if (!options.no_walls) say_file(postprocess::export_walls(flow.walls, options.out));
  say_file(postprocess::export_macro(options.out));
}

void export_file(const ExportOptions& options) {
  const FileFormat format = file_format(options.file);
  if (format.name == "clogflow flow") return export_flow(options);
  require(format.name == "clogflow run", "{}: a \"{}\" file (run files and flow files can be exported)",
          options.file.string(), shown_text(format.name));
  export_run(options);
}

}  // namespace

void add_export(CLI::App& app) {
  auto* verb = app.add_subcommand("export", "a run or a flow for ParaView (.pvd, .vtp, .hdf) and OVITO (.xyz)");
  auto options = std::make_shared<ExportOptions>();
  verb->add_option("file", options->file, "run_NNNN.h5 or flow.h5")->required();
  verb->add_option("--out", options->out, "folder for the files")->required();
  verb->add_option("--format", options->format, "vtk: for ParaView, xyz: for OVITO, all: both")
      ->check(CLI::IsMember({"vtk", "xyz", "all"}))
      ->capture_default_str();
  verb->add_option("--flow", options->flow, "flow.h5 of the run, to be exported with it");
  verb->add_flag("--no-walls", options->no_walls, "leave the walls out");
  verb->callback([options] { export_file(*options); });
}

}  // namespace clogflow::cli
