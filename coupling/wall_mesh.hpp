// The walls' triangles joined at common corners.
#pragma once

#include <array>
#include <vector>

#include "coupling/walls.hpp"

namespace clog {

/// Triangles that meet have common corner numbers and whole common edges: where a corner lies on the edge
/// of another triangle, that triangle is cut there, so the way in which a file cuts a surface does not
/// matter.
struct WallMesh {
  Walls triangles;
  std::vector<std::array<int, 3>> corner;  ///< corner numbers of each triangle
  int corners = 0;
};

/// \throws Error if a triangle has no area or comes twice
WallMesh join_walls(const Walls& walls);

/// A closed way along edges that belong to one triangle alone: the surface is open there.
struct WallRim {
  double length = 0;           ///< [m]
  Vec3 place = Vec3::Zero();   ///< one of its corners [m]
};

/// The shortest first.
std::vector<WallRim> open_rims(const WallMesh& mesh);

}  // namespace clog
