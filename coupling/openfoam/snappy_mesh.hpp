// The mesh of an STL channel: a box of equal cells that snappyHexMesh refines around the neck and
// fits to the walls.
#pragma once

#include <array>
#include <map>
#include <string>

#include "coupling/geometry/stl_channel.hpp"
#include "coupling/openfoam/flow_lattice.hpp"
#include "coupling/openfoam/foam_dictionaries.hpp"
#include "coupling/scene/scene.hpp"

namespace clogflow {

/// Lengths in neck widths: OpenFOAM's meshing and its interpolation compare volumes with absolute
/// numbers, and count cells of micrometres as nothing.
struct SnappyMesh {
  double unit;                      ///< the neck's width [m]
  double inlet, outlet;             ///< x of the mesh's ends; the inlet lies in the straight part
  Vec3 low, high;                   ///< corners of the box: a layer of cells outside the walls
  std::array<int, 3> cells;         ///< of the box, twice as large as those in the neck
  double refined_from, refined_to;  ///< x between which cells have the size of the neck's
};

/// Mesh with flow.mesh_cells_per_neck cells across the neck's width, and half as many where the
/// section is more than three times the neck's.
SnappyMesh snappy_mesh(const Scene& scene, const StlChannel& channel);

/// The points of the regular grid for an STL channel: the box around its walls.
FlowLattice stl_lattice(const Scene& scene, const StlChannel& channel, const SnappyMesh& mesh);

/// The generated files of the case but for system/sceneDict, by name.
std::map<std::string, std::string> snappy_files(const Scene& scene, const StlChannel& channel, const SnappyMesh& mesh);

/// Sampled in neck widths, and not the velocity but in which cell each point lies (cell_samples.hpp): at the hanging
/// nodes of a refined mesh cellPointFace was wrong by a third of the neck's mean velocity, and cellPoint errs as much
/// as the solver does.
inline Sampling snappy_sampling(const SnappyMesh& mesh) {
  return {.unit = mesh.unit, .interpolation = "cell", .field = "C"};
}

/// What system/sceneDict holds for snappyHexMeshDict.
std::string snappy_entries(const SnappyMesh& mesh);

}  // namespace clogflow
