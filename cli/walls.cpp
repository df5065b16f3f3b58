// clog walls: the channel of a scene as an STL file with named inlet and outlet.
#include <filesystem>
#include <memory>

#include "cli/output.hpp"
#include "cli/verbs.hpp"
#include "coupling/base/publish_file.hpp"
#include "coupling/geometry/stl_channel.hpp"
#include "coupling/scene/scene.hpp"

namespace clogflow::cli {
namespace {

struct WallsOptions {
  std::filesystem::path scene, out;
  Overrides overrides;
};

// What `geometry.stl_unit = "1 um"` reads back.
constexpr double micrometre = 1e-6;

void write_walls(const WallsOptions& options) {
  const std::string text = channel_stl(read_scene(options.scene, options.overrides).geometry, micrometre);
  publish_file(text, options.out);
  print_result("{}: walls, inlet and outlet, in micrometres (geometry.stl_unit = \"1 um\")\n", options.out.string());
}

}  // namespace

void add_walls(CLI::App& app) {
  auto* verb = app.add_subcommand("walls", "the channel of a scene as an STL file, to start another shape from");
  auto options = std::make_shared<WallsOptions>();
  verb->add_option("scene", options->scene, "scene file (TOML)")->required();
  verb->add_option("--out", options->out, "the STL file")->required();
  verb->add_option("--set", options->overrides, "key=value: overrides the scene")->allow_extra_args(false);
  verb->callback([options] { write_walls(*options); });
}

}  // namespace clogflow::cli
