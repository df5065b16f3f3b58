#include "coupling/openfoam/coarser_case.hpp"

#include "coupling/base/require.hpp"

namespace clogflow {
namespace {

namespace fs = std::filesystem;

constexpr double fewest_cells = 4;

}  // namespace

Scene coarser_scene(const Scene& scene) {
  Scene coarse = scene;
  coarse.flow.mesh_cells_per_neck = scene.flow.mesh_cells_per_neck / coarsening;
  coarse.flow.extrapolate = false;
  require(coarse.flow.mesh_cells_per_neck >= fewest_cells,
          "flow.mesh_cells_per_neck = {} (a check solves with half of them, and {} is the least); "
          "give at least {}",
          scene.flow.mesh_cells_per_neck, fewest_cells, coarsening * fewest_cells);
  return coarse;
}

fs::path coarser_folder(const fs::path& folder) { return folder / "coarse"; }

}  // namespace clogflow
