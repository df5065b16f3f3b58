#include "coupling/map_flow.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <optional>

#include "coupling/channel_geometry.hpp"
#include "coupling/channel_shape.hpp"
#include "coupling/content_hash.hpp"
#include "coupling/duct_flow.hpp"
#include "coupling/flow_error.hpp"
#include "coupling/flow_flux.hpp"
#include "coupling/flow_mesh.hpp"
#include "coupling/foam_log.hpp"
#include "coupling/lookup_error.hpp"
#include "coupling/require.hpp"
#include "coupling/text_file.hpp"
#include "coupling/wall_sections.hpp"

namespace clog {
namespace {

namespace fs = std::filesystem;

// Flat cells cut the corners of curved walls: points there have no sample and count as solid.
constexpr double largest_lost_share = 0.02;

// The sampled row for a row -half_width <= j < half_width, and its sign for the y component.
struct Mirrored {
  int index;
  float sign;
};

Mirrored mirror_y(int j, int first) {
  return j >= first ? Mirrored{j, 1.0f} : Mirrored{-1 - j, -1.0f};
}

Mirrored mirror_z(int k, int layers) {
  const int other = layers - 1 - k;
  return k <= other ? Mirrored{k, 1.0f} : Mirrored{other, -1.0f};
}

FlowGrid empty_grid(const FlowLattice& lattice) {
  FlowGrid grid;
  const double h = lattice.spacing;
  grid.points = {lattice.x_end - lattice.x_begin, 2 * lattice.half_width, lattice.height};
  grid.origin = {lattice.coordinate(lattice.x_begin), lattice.coordinate(-lattice.half_width),
                 lattice.coordinate(lattice.z_begin)};
  grid.spacing = h;
  const std::size_t count =
      static_cast<std::size_t>(grid.points[0]) * grid.points[1] * grid.points[2];
  grid.velocity.resize(3 * count);
  grid.solid.resize(count);
  return grid;
}

class Mapper {
public:
  Mapper(const Scene& scene, const FlowLattice& lattice, const FoamSamples& samples)
      : scene_(scene),
        lattice_(lattice),
        samples_(samples),
        shape_(channel_shape(scene)),
        duct_(scene.geometry.channel_width, scene.geometry.neck_height) {}

  FlowGrid grid() const {
    FlowGrid grid = empty_grid(lattice_);
    for (int k = 0; k < grid.points[2]; ++k) {
      for (int j = 0; j < grid.points[1]; ++j) fill_row(grid, j, k);
    }
    return grid;
  }

private:
  void fill_row(FlowGrid& grid, int row, int k) const {
    const int j = row - lattice_.half_width;
    const double y = lattice_.coordinate(j);
    const auto developed =
        static_cast<float>(scene_.flow.mean_velocity * duct_(y, lattice_.coordinate(k)));
    const Mirrored my = mirror_y(j, lattice_.y_sampled);
    const Mirrored mz = mirror_z(k, lattice_.height);
    for (int i = lattice_.x_begin; i < lattice_.x_end; ++i) {
      const std::size_t at = grid.index(i - lattice_.x_begin, row, k);
      grid.solid[at] = is_solid(lattice_.coordinate(i), y);
      if (grid.solid[at]) continue;
      float* velocity = &grid.velocity[3 * at];
      if (i < lattice_.x_sampled) {
        velocity[0] = developed;
        continue;
      }
      const std::size_t from =
          samples_.index(i - lattice_.x_sampled, my.index - lattice_.y_sampled, mz.index);
      require(samples_.found[from],
              "no sample at ({}, {}, {}) m, inside the fluid (the samples file is incomplete); "
              "delete the "
              "file `solved` of the case and run its Allrun again",
              lattice_.coordinate(i), lattice_.coordinate(my.index), lattice_.coordinate(mz.index));
      velocity[0] = samples_.velocity[from][0];
      velocity[1] = my.sign * samples_.velocity[from][1];
      velocity[2] = mz.sign * samples_.velocity[from][2];
    }
  }

  // Points on a wall count as solid: OpenFOAM may or may not find them.
  bool is_solid(double x, double y) const {
    const double margin = 1e-6 * lattice_.spacing;
    const ChannelSide& side = y > 0 ? shape_.upper : shape_.lower;
    double wall = side.distance(x);
    for (const double near : {x - margin, x + margin}) wall = std::min(wall, side.distance(near));
    return std::abs(y) >= wall - margin;
  }

  const Scene& scene_;
  const FlowLattice& lattice_;
  const FoamSamples& samples_;
  ChannelShape shape_;
  DuctFlow duct_;
};

nlohmann::json as_json(const std::vector<PlaneFlux>& planes) {
  nlohmann::json list = nlohmann::json::array();
  for (const PlaneFlux& plane : planes) list.push_back({{"x", plane.x}, {"flux", plane.flux}, {"error", plane.error}});
  return list;
}

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
          "{} holds the flow of other inputs ({}, not {}) or of another template; run {}",
          folder.string(), first_line(folder / "solved"), hash, run);
  return hash;
}

// The error told by the coarser solution of a case, if it has one; and the samples and the pressure
// drop extrapolated from both where the scene wants that.
nlohmann::json use_coarser_flow(const fs::path& folder, const Scene& scene, FoamSamples& samples,
                                double& pressure_drop) {
  const std::optional<CoarserFlow> coarse = read_coarser_flow(folder, scene);
  if (!coarse) return nullptr;
  const double mean = neck_mean_velocity(scene);
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
  return {{"cells_per_neck", {scene.flow.mesh_cells_per_neck, coarse->cells_per_neck}},
          {"extrapolated", scene.flow.extrapolate},
          {"velocity_rms", velocity.rms},
          {"velocity_99_percent", velocity.most},
          {"velocity_largest", velocity.largest},
          {"pressure_drop", of_drop}};
}

}  // namespace

LookupError lookup_error(const FlowGrid& grid, double speed) {
  const auto [nx, ny, nz] = grid.points;
  double second = 0, slope = 0, count = 0;
  const std::array<std::size_t, 3> step{1, static_cast<std::size_t>(nx),
                                        static_cast<std::size_t>(nx) * ny};
  for (int k = 1; k + 1 < nz; ++k)
    for (int j = 1; j + 1 < ny; ++j)
      for (int i = 1; i + 1 < nx; ++i) {
        const std::size_t at = grid.index(i, j, k);
        bool fluid = !grid.solid[at];
        for (const std::size_t s : step)
          fluid = fluid && !grid.solid[at - s] && !grid.solid[at + s];
        if (!fluid) continue;
        ++count;
        for (std::size_t c = 0; c < 3; ++c) {
          double curvature = 0;
          for (const std::size_t s : step) {
            const double before = grid.velocity[3 * (at - s) + c];
            const double here = grid.velocity[3 * at + c];
            const double after = grid.velocity[3 * (at + s) + c];
            curvature += before - 2 * here + after;
            slope += std::pow((after - before) / 2, 2);
          }
          second += curvature * curvature;
        }
      }
  if (count == 0) return {0, 0};
  return {.trilinear = std::sqrt(second / count) / 12 / speed,
          .nearest = std::sqrt(slope / count / 12) / speed};
}

FlowGrid stl_grid_from_samples(const Scene& scene, const FlowSpace& space,
                               const FoamSamples& samples) {
  const FlowLattice& lattice = space.lattice;
  FlowGrid grid = empty_grid(lattice);
  const DuctFlow duct(scene.geometry.channel_width, scene.geometry.neck_height);
  std::vector<double> heights;
  for (int k = 0; k < lattice.height; ++k)
    heights.push_back(lattice.coordinate(lattice.z_begin + k));
  std::size_t fluid = 0, lost = 0;
  for (int i = lattice.x_begin; i < lattice.x_end; ++i)
    for (int row = 0; row < grid.points[1]; ++row) {
      const double y = lattice.coordinate(row - lattice.half_width);
      const bool upstream = i < lattice.x_sampled;
      // Beside edges of triangles, which often lie on the grid's own planes.
      const double x = upstream ? space.straight : lattice.coordinate(i) + 1.3e-6 * lattice.spacing;
      const std::vector<bool> inside =
          inside_along_z(space.walls, x, y + 1.7e-6 * lattice.spacing, heights);
      for (int k = 0; k < lattice.height; ++k) {
        const std::size_t at = grid.index(i - lattice.x_begin, row, k);
        grid.solid[at] = !inside[k];
        if (!inside[k]) continue;
        ++fluid;
        float* velocity = &grid.velocity[3 * at];
        if (upstream) {
          velocity[0] = static_cast<float>(scene.flow.mean_velocity * duct(y, heights[k]));
          continue;
        }
        const std::size_t from = samples.index(i - lattice.x_sampled, row, k);
        lost += !samples.found[from];
        grid.solid[at] = !samples.found[from];
        for (int c = 0; c < 3; ++c)
          velocity[c] = samples.found[from] ? samples.velocity[from][c] : 0;
      }
    }
  const double share =
      static_cast<double>(lost) / static_cast<double>(std::max<std::size_t>(fluid, 1));
  require(share <= largest_lost_share,
          "{:.2g} % of the points between the walls have no sample (allowed {} %: the mesh does "
          "not follow "
          "the walls); refine flow.mesh_cells_per_neck",
          100 * share, 100 * largest_lost_share);
  grid.provenance["points_lost_at_walls"] = share;
  return grid;
}

FlowGrid grid_from_samples(const Scene& scene, const FlowLattice& lattice,
                           const FoamSamples& samples) {
  return Mapper(scene, lattice, samples).grid();
}

FlowGrid map_flow(const fs::path& folder) {
  require(fs::is_directory(folder),
          "{} is missing (expected the folder of a flow case); write it: clog case",
          folder.string());
  const fs::path scene_file = folder / "scene.toml";
  const std::string scene_text = read_text_file(scene_file);
  const Scene scene = read_scene(scene_file);
  const std::string hash = solved_hash(folder, scene);
  const FlowSpace space = flow_space(scene);
  FoamSamples samples = read_flow_samples(folder, space);
  double drop = read_pressure_drop(folder);
  const nlohmann::json error = use_coarser_flow(folder, scene, samples, drop);
  FlowGrid grid = space.walls.empty() ? grid_from_samples(scene, space.lattice, samples)
                                      : stl_grid_from_samples(scene, space, samples);
  grid.walls = space.walls.empty() ? channel_walls(scene) : space.walls;
  grid.scene_text = scene_text;
  grid.hash = hash;
  grid.provenance.update(read_foam_logs(folder, space.copies));
  grid.provenance["pressure_drop"] = scene.fluid.density * drop;
  if (!error.is_null()) grid.provenance["mesh_error"] = error;
  const auto planes = grid_fluxes(grid, scene, space.lattice.coordinate(space.lattice.x_sampled));
  grid.provenance["grid_flux"] = as_json(planes);
  const LookupError lookup = lookup_error(grid, neck_mean_velocity(scene));
  const double side = std::min(scene.geometry.neck_width, scene.geometry.neck_height);
  grid.provenance["lookup_error"] = {
      {"trilinear_rms", lookup.trilinear},
      {"nearest_rms", lookup.nearest},
      {"trilinear_in_neck", neck_lookup_error(Lookup::trilinear, grid.spacing, side)},
      {"nearest_in_neck", neck_lookup_error(Lookup::nearest, grid.spacing, side)}};
  grid.provenance["date"] = utc_now();
  for (const PlaneFlux& plane : planes)
    require(std::abs(plane.error) < flux_tolerance,
            "the flux through x = {} m differs by {:.1f} % from that of the scene (allowed {} %); "
            "refine flow.mesh_cells_per_neck or flow.grid_spacing",
            plane.x, 100 * plane.error, 100 * flux_tolerance);
  return grid;
}

}  // namespace clog
