// clog case: a complete OpenFOAM case for a scene.
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "cli/verbs.hpp"
#include "coupling/content_hash.hpp"
#include "coupling/foam_case_writer.hpp"
#include "coupling/source_folder.hpp"
#include "coupling/stl_channel.hpp"

namespace clog::cli {
namespace {

struct CaseOptions {
  std::filesystem::path scene, folder;
  Overrides overrides;
  bool check = false;
};

void write_case(const CaseOptions& options) {
  const Scene scene = read_scene(options.scene, options.overrides);
  const auto state =
      write_foam_case(scene, options.folder, source_folder() / "foam_case",
                      options.check ? FoamCaseCheck::with_coarser_mesh : FoamCaseCheck::without);
  const std::string note = is_stl_channel(scene) ? read_stl_channel(scene)->note : "";
  if (!note.empty()) fmt::print(stderr, "clog: {}\n", note);
  const std::string hash = content_hash(flow_inputs(scene));
  if (state == FoamCaseState::solved) {
    fmt::print("flow {} is already solved in {}\n", hash, options.folder.string());
  } else {
    fmt::print("flow {} written; solve it with {}\n", hash, (options.folder / "Allrun").string());
  }
}

}  // namespace

void add_case(CLI::App& app) {
  auto* verb = app.add_subcommand("case", "write a complete OpenFOAM case for the flow of a scene");
  auto options = std::make_shared<CaseOptions>();
  verb->add_option("scene", options->scene, "scene file (TOML)")->required();
  verb->add_option("folder", options->folder, "of the case; made if absent")->required();
  verb->add_option("--set", options->overrides, "key=value: overrides the scene")
      ->allow_extra_args(false);
  verb->add_flag("--check", options->check,
                 "solve on a coarser mesh too, even without flow.extrapolate; clog map then "
                 "estimates the error");
  verb->callback([options] { write_case(*options); });
}

}  // namespace clog::cli
