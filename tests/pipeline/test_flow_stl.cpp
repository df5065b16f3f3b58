// Flows through walls from an STL file: snappyHexMesh, simpleFoam, the mapper.
#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

#include "coupling/base/source_folder.hpp"
#include "coupling/flow/flow_flux.hpp"
#include "coupling/flow/map_flow.hpp"
#include "coupling/geometry/stl_channel.hpp"
#include "coupling/openfoam/foam_case_writer.hpp"
#include "tests/coupling/flow_scene.hpp"
#include "tests/pipeline/flow_case.hpp"

namespace clogflow {
namespace {

namespace fs = std::filesystem;

FlowGrid solved(const Scene& scene, const fs::path& folder) {
  write_foam_case(scene, folder, foam_template());
  const ShellResult run = solve(folder);
  EXPECT_EQ(run.status, 0) << run.output;
  FlowGrid grid = map_flow(folder);
  check_flow_fits(grid, scene);
  return grid;
}

// The flow keeps its rate through every plane of the mesh, and is its own mirror image.
void expect_laws(const FlowGrid& grid, double rate, double neck_mean) {
  EXPECT_GT(grid.record.mass_flux->size(), 4u);
  for (const SurfaceFlux& each : *grid.record.mass_flux) EXPECT_NEAR(each.flux / rate, 1, 1e-4) << each.surface;
  double uneven = 0;
  const auto [nx, ny, nz] = grid.points;
  const auto& u = grid.velocity;
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        const std::size_t at = 3 * grid.index(i, j, k), mirror = 3 * grid.index(i, ny - 1 - j, k);
        uneven += std::pow(double{u[at]} - u[mirror], 2) + std::pow(double{u[at + 1]} + u[mirror + 1], 2);
      }
  // The mesh is fitted to the walls in an order of its own, so it is a mirror image only nearly.
  EXPECT_LT(std::sqrt(uneven / static_cast<double>(grid.solid.size())) / neck_mean, 0.01);
}

TEST(StlFlow, OfThePapersChannelIsThatOfTheBlockMesh) {
  const ScratchFolder scratch;
  const Scene keys = flow_scene({"geometry.channel_length=500 um", "geometry.neck_length=150 um"});
  write_file(scratch.path() / "walls.stl", channel_stl(keys.geometry, 1e-6));
  std::string text = effective_scene(keys);
  const std::size_t section = text.find("[fluid]");
  write_file(scratch.path() / "scene.toml",
             "[geometry]\nstl = \"walls.stl\"\nstl_unit = \"1 um\"\nneck_width = \"100 um\"\n"
             "neck_length = \"150 um\"\n\n" +
                 text.substr(section));
  const Scene scene = read_scene(scratch.path() / "scene.toml");
  const FlowGrid fitted = solved(scene, scratch.path() / "stl");
  const FlowGrid blocks = solved(keys, scratch.path() / "blocks");
  expect_laws(fitted, 2e-10, 20e-3);
  EXPECT_LT(fitted.record.points_lost_at_walls.value(), 1e-3);

  // Wherever both grids have a point: same places are solid, velocities agree as 12 cells allow.
  double squares = 0, count = 0, solid = 0;
  const auto [nx, ny, nz] = fitted.points;
  const int ahead = static_cast<int>(std::lround((fitted.origin.x - blocks.origin.x) / fitted.spacing));
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 1; i < nx; ++i) {
        if (i + ahead < 1 || i + ahead >= blocks.points[0]) continue;
        const std::size_t a = fitted.index(i, j, k), b = blocks.index(i + ahead, j, k);
        ++count;
        solid += fitted.solid[a] != blocks.solid[b];
        for (int c = 0; c < 3; ++c)
          squares += std::pow(double{fitted.velocity[3 * a + c]} - blocks.velocity[3 * b + c], 2);
      }
  EXPECT_GT(count, 1e5);
  EXPECT_LT(solid / count, 1e-3);
  EXPECT_LT(std::sqrt(squares / count) / 20e-3, 0.02);
  EXPECT_EQ(fitted.walls.size(), blocks.walls.size());
}

TEST(StlFlow, OfTheShippedPore) {
  const ScratchFolder scratch;
  const Scene scene = read_scene(source_folder() / "scenes" / "pore.toml", {"flow.mesh_cells_per_neck=14"});
  const FlowGrid grid = solved(scene, scratch.path() / "pore");
  expect_laws(grid, 5e-3 * 3e-4 * 1e-4, 15e-3);
  EXPECT_LT(grid.record.points_lost_at_walls.value(), 0.01);
  // The case carries its walls: moved and mapped elsewhere it gives the same file.
  fs::rename(scratch.path() / "pore", scratch.path() / "moved");
  EXPECT_EQ(map_flow(scratch.path() / "moved").velocity, grid.velocity);
  EXPECT_EQ(write_foam_case(scene, scratch.path() / "moved", foam_template()), FoamCaseState::solved);
}

/// What passes the plane nearest to x where y lies between two values [m3/s].
double flux_between(const FlowGrid& grid, double x, double from, double to) {
  const int i = static_cast<int>(std::lround((x - grid.origin.x) / grid.spacing));
  double sum = 0;
  for (int k = 0; k < grid.points[2]; ++k)
    for (int j = 0; j < grid.points[1]; ++j) {
      const double y = grid.origin.y + j * grid.spacing;
      if (y > from && y < to) sum += grid.velocity[3 * grid.index(i, j, k)];
    }
  return sum * grid.spacing * grid.spacing;
}

TEST(StlFlow, TwoNecksCarryHalfEach) {
  const ScratchFolder scratch;
  const Scene scene = read_scene(source_folder() / "scenes" / "two_necks.toml",
                                 {"flow.mesh_cells_per_neck=10", "flow.grid_spacing=5 um"});
  const FlowGrid grid = solved(scene, scratch.path() / "two");
  const double rate = 5e-3 * 4e-4 * 1e-4;
  expect_laws(grid, rate, 10e-3);
  const double lower = flux_between(grid, 50e-6, -2e-4, 0), upper = flux_between(grid, 50e-6, 0, 2e-4);
  EXPECT_NEAR(lower / upper, 1, 0.02);
  EXPECT_NEAR((lower + upper) / rate, 1, 0.05);
  EXPECT_EQ(flux_between(grid, 50e-6, -20e-6, 20e-6), 0) << "in the wall between them";
}

TEST(StlFlow, APipeCarriesPoiseuillesFlow) {
  const ScratchFolder scratch;
  const Scene scene =
      read_scene(source_folder() / "scenes" / "pipe.toml", {"flow.mesh_cells_per_neck=10", "flow.grid_spacing=5 um"});
  const FlowGrid grid = solved(scene, scratch.path() / "pipe");
  const double radius = std::sqrt(scene.geometry.inlet_area / M_PI), rate = 2.5e-3 * scene.geometry.inlet_area;
  EXPECT_NEAR(flux_between(grid, 50e-6, -1e-3, 1e-3) / rate, 1, 0.05);
  // Of the mesh, halfway between its inlet and the narrowing; upstream of the mesh the parabola is set.
  for (const auto& [x, limit] : {std::pair(grid.origin.x, 1e-6), {-350e-6, 0.03}}) {
    const int i = static_cast<int>(std::lround((x - grid.origin.x) / grid.spacing));
    ASSERT_GE(i, 0);
    double squares = 0, count = 0;
    for (int k = 0; k < grid.points[2]; ++k)
      for (int j = 0; j < grid.points[1]; ++j) {
        const std::size_t at = grid.index(i, j, k);
        if (grid.solid[at]) continue;
        const double y = grid.origin.y + j * grid.spacing, z = grid.origin.z + k * grid.spacing - 150e-6;
        const double law = std::max(0.0, 2 * 2.5e-3 * (1 - (y * y + z * z) / (radius * radius)));
        squares += std::pow(grid.velocity[3 * at] - law, 2), ++count;
      }
    EXPECT_LT(std::sqrt(squares / count) / 2.5e-3, limit) << x;
    EXPECT_NEAR(count * grid.spacing * grid.spacing / scene.geometry.inlet_area, 1, 0.02) << x;
  }
}

}  // namespace
}  // namespace clogflow
