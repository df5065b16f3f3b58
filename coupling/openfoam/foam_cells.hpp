// Reads the cells of a solved flow case: where they lie, what flows in them, which of them touch.
#pragma once

#include <filesystem>
#include <vector>

#include "coupling/base/vector.hpp"

namespace clogflow {

/// The cells of a mesh with the flow in their centres, and the faces on its walls, where nothing flows.
struct FoamCells {
  std::vector<Vec3> centre;           ///< in units of the mesh
  std::vector<Vec3> velocity;         ///< [m/s]
  std::vector<int> owner, neighbour;  ///< the two cells of each face between cells
  std::vector<Vec3> wall;             ///< centres of the faces on walls, in units of the mesh
  std::vector<int> wall_cell;         ///< the cell before each of them
};

/// Of the newest time of the case, whose centres `postProcess -func writeCellCentres` has written.
/// \throws Error naming the file on one that is missing, cut short, or does not fit the others
FoamCells read_foam_cells(const std::filesystem::path& folder);

}  // namespace clogflow
