// clog map: sampled OpenFOAM velocities to flow.h5.
#include <filesystem>
#include <memory>

#include "cli/output.hpp"
#include "cli/verbs.hpp"
#include "coupling/flow/flow_reach.hpp"
#include "coupling/flow/map_flow.hpp"

namespace clogflow::cli {
namespace {

struct MapOptions {
  std::filesystem::path folder, out;
};

void write_map(const MapOptions& options) {
  const FlowGrid grid = map_flow(options.folder);
  const FlowRecord& record = grid.record;
  write_flow_grid(grid, options.out);
  print_result("{}: flow {}, {} x {} x {} points of {:.4g} um, flux of every plane within {:.2g} %\n",
               options.out.string(), grid.hash, grid.points[0], grid.points[1], grid.points[2], 1e6 * grid.spacing,
               100 * *record.grid_flux_largest_error);
  print_words(
      "reading it adds, in % of the neck's mean velocity: rms {:.2g} trilinear, {:.2g} nearest; "
      "in the neck, walls included, {:.2g} and {:.2g}; {:.3g} MB of memory\n",
      100 * record.lookup_error->trilinear_rms, 100 * record.lookup_error->nearest_rms,
      100 * record.lookup_error->trilinear_in_neck, 100 * record.lookup_error->nearest_in_neck,
      1e-6 * static_cast<double>(sizeof(float) * grid.velocity.size() + grid.solid.size()));
  if (const auto drop = channel_pressure_drop(grid, read_scene(options.folder / "scene.toml")))
    print_words(
        "pressure drop from the inlet of the scene's channel: {:.4g} Pa, {:.4g} Pa of it in what "
        "was solved\n",
        *drop, *record.pressure_drop);
  if (!record.mesh_error) return;
  const MeshError& error = *record.mesh_error;
  print_words(
      "{}, in % of the neck's mean velocity: "
      "rms {:.2g}, {:.2g} at 99 of 100 points, at most {:.2g} beside the edge; solved pressure "
      "drop "
      "{:.4g} Pa within {:.2g} %\n",
      error.extrapolated ? "extrapolated from this mesh and a coarser one; error, 1.25 times what that changed"
                         : "error of the mesh, estimated from a coarser one",
      100 * error.velocity_rms, 100 * error.velocity_99_percent, 100 * error.velocity_largest, *record.pressure_drop,
      100 * error.pressure_drop);
}

}  // namespace

void add_map(CLI::App& app) {
  auto* verb = app.add_subcommand("map", "sampled OpenFOAM velocities of a case to a regular grid");
  auto options = std::make_shared<MapOptions>();
  verb->add_option("folder", options->folder, "of a flow case that its Allrun has solved")->required();
  verb->add_option("--out", options->out, "the flow file, for example flow.h5")->required();
  verb->callback([options] { write_map(*options); });
}

}  // namespace clogflow::cli
