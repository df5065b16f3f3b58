#include "coupling/flow/map_flow.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <optional>

#include "coupling/base/content_hash.hpp"
#include "coupling/base/require.hpp"
#include "coupling/base/text_file.hpp"
#include "coupling/flow/flow_error.hpp"
#include "coupling/flow/flow_flux.hpp"
#include "coupling/flow/grid_from_samples.hpp"
#include "coupling/flow/lookup_error.hpp"
#include "coupling/flow/straight_flux.hpp"
#include "coupling/geometry/channel_geometry.hpp"
#include "coupling/geometry/channel_shape.hpp"
#include "coupling/openfoam/flow_space.hpp"
#include "coupling/openfoam/foam_log.hpp"
#include "coupling/scene/grid_spacing.hpp"

namespace clogflow {
namespace {

namespace fs = std::filesystem;

std::string utc_now() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&now));
  return text;
}

std::string first_line(const fs::path& file) {
  const std::string text = read_text_file(file);
  return text.substr(0, text.find('\n'));
}

// The hash of the case, once it is sure that scene.toml, the case and its results belong together.
std::string solved_hash(const fs::path& folder, const Scene& scene) {
  const std::string hash = first_line(folder / "hash");
  const std::string run = (folder / "Allrun").string();
  require(content_hash(flow_inputs(scene)) == hash,
          "{} does not describe the flow {} of its case (edited, or of another version?); write "
          "the case again",
          (folder / "scene.toml").string(), hash);
  require(fs::exists(folder / "solved"), "{} is not solved; run {}", folder.string(), run);
  require(read_text_file(folder / "solved") == read_text_file(folder / "hash"),
          "{} holds the flow of other inputs ({}, not {}) or of another template; run {}", folder.string(),
          first_line(folder / "solved"), hash, run);
  return hash;
}

/// \return the largest relative error of the flow rate in any plane of the grid
double check_every_plane(const FlowGrid& grid, const Scene& scene) {
  double largest = 0;
  for (int i = 0; i < grid.points[0]; ++i) {
    const PlaneFlux plane = grid_plane(grid, i, scene);
    require(std::abs(plane.error) < flux_tolerance,
            "the flux through x = {} m differs by {:.1f} % from that of the scene (allowed {} %); "
            "refine flow.mesh_cells_per_neck or flow.grid_spacing",
            plane.x, 100 * plane.error, 100 * flux_tolerance);
    largest = std::max(largest, std::abs(plane.error));
  }
  return largest;
}

// The error told by the coarser solution of a case, if it has one; and the samples and the pressure
// drop extrapolated from both where the scene wants that.
std::optional<MeshError> use_coarser_flow(const fs::path& folder, const Scene& scene, FoamSamples& samples,
                                          double& pressure_drop) {
  const std::optional<CoarserFlow> coarse = read_coarser_flow(folder, scene);
  if (!coarse) return {};
  const double mean = neck_mean_velocity(scene.geometry, scene.flow.mean_velocity);
  VelocityError velocity{};
  double of_drop = richardson_error(pressure_drop, coarse->pressure_drop);
  if (scene.flow.extrapolate) {
    velocity = extrapolate(samples, coarse->samples, mean);
    const double told = told_error(pressure_drop, coarse->pressure_drop);
    pressure_drop += correction(pressure_drop, coarse->pressure_drop);
    of_drop = told / std::abs(pressure_drop);
  } else {
    velocity = richardson_error(samples, coarse->samples, mean);
  }
  return MeshError{.cells_per_neck = {scene.flow.mesh_cells_per_neck, coarse->cells_per_neck},
                   .extrapolated = scene.flow.extrapolate,
                   .velocity_rms = velocity.rms,
                   .velocity_99_percent = velocity.most,
                   .velocity_largest = velocity.largest,
                   .pressure_drop = of_drop};
}

}  // namespace

FlowGrid map_flow(const fs::path& folder) {
  require(fs::is_directory(folder), "{} is missing (expected the folder of a flow case); write it: clog case",
          folder.string());
  const fs::path scene_file = folder / "scene.toml";
  const std::string scene_text = read_text_file(scene_file);
  const Scene scene = read_scene(scene_file);
  const std::string hash = solved_hash(folder, scene);
  const FlowSpace space = flow_space(scene);
  FoamSamples samples = read_flow_samples(folder, space);
  double drop = read_pressure_drop(folder);
  const std::optional<MeshError> mesh_error = use_coarser_flow(folder, scene, samples, drop);
  FlowGrid grid = space.walls.empty() ? grid_from_samples(scene, space.lattice, samples)
                                      : stl_grid_from_samples(scene, space, samples);
  FlowRecord& record = grid.record;
  if (space.walls.empty()) record.flow_rate_restored = restore_flow_rate(grid, scene);
  grid.walls = space.walls.empty() ? channel_walls(scene.geometry) : space.walls;
  grid.scene_text = scene_text;
  grid.hash = hash;
  record = read_foam_logs(folder, space.copies, record);
  record.pressure_drop = scene.fluid.density * drop;
  record.mesh_error = mesh_error;
  record.grid_flux = grid_fluxes(grid, scene, space.lattice.coordinate(space.lattice.x_sampled));
  record.grid_flux_largest_error = check_every_plane(grid, scene);
  const LookupError lookup = lookup_error(grid, neck_mean_velocity(scene.geometry, scene.flow.mean_velocity));
  const double side = std::min(scene.geometry.neck_width, scene.geometry.neck_height);
  record.lookup_error = {.trilinear_rms = lookup.trilinear,
                         .nearest_rms = lookup.nearest,
                         .trilinear_in_neck = neck_lookup_error(Lookup::trilinear, grid.spacing, side),
                         .nearest_in_neck = neck_lookup_error(Lookup::nearest, grid.spacing, side)};
  record.date = utc_now();
  return grid;
}

}  // namespace clogflow
