// clog case: a complete OpenFOAM case for a scene.
#include <filesystem>
#include <memory>

#include "cli/output.hpp"
#include "cli/verbs.hpp"
#include "coupling/base/content_hash.hpp"
#include "coupling/base/source_folder.hpp"
#include "coupling/geometry/stl_channel.hpp"
#include "coupling/openfoam/foam_case_writer.hpp"

namespace clogflow::cli {
namespace {

struct CaseOptions {
  std::filesystem::path scene, folder;
  Overrides overrides;
  bool check = false;
};

void write_case(const CaseOptions& options) {
  const Scene scene = read_scene(options.scene, options.overrides);
  const auto state = write_foam_case(scene, options.folder, source_folder() / "foam_case",
                                     options.check ? FoamCaseCheck::with_coarser_mesh : FoamCaseCheck::without);
  const std::string note = is_stl_channel(scene.geometry) ? read_stl_channel(scene.geometry)->note : "";
  if (!note.empty()) print_note(note);
  const std::string hash = content_hash(flow_inputs(scene));
  if (state == FoamCaseState::solved) {
    print_result("flow {} is already solved in {}\n", hash, options.folder.string());
  } else {
    print_result("flow {} written; solve it with {}\n", hash, (options.folder / "Allrun").string());
  }
}

}  // namespace

void add_case(CLI::App& app) {
  auto* verb = app.add_subcommand("case", "write a complete OpenFOAM case for the flow of a scene");
  auto options = std::make_shared<CaseOptions>();
  verb->add_option("scene", options->scene, "scene file (TOML)")->required();
  verb->add_option("folder", options->folder, "of the case; made if absent")->required();
  verb->add_option("--set", options->overrides, "key=value: overrides the scene")->allow_extra_args(false);
  verb->add_flag("--check", options->check,
                 "solve on a coarser mesh too, even without flow.extrapolate; clog map then "
                 "estimates the error");
  verb->callback([options] { write_case(*options); });
}

}  // namespace clogflow::cli
