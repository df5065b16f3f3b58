// The walls' triangles joined at common corners.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "coupling/geometry/corner_welding.hpp"
#include "coupling/geometry/walls.hpp"

namespace clogflow {

/// Corners that differ by less than this share of the largest extent are one: single precision, in
/// which programs write their files, rounds by 6e-8 of a coordinate, and seams that were computed
/// twice by some times that.
constexpr double weld_share = 1e-6;

/// Facets that say nothing, left out. Numbers count from 1.
struct LeftOut {
  std::size_t without_area = 0, doubled = 0;
  std::size_t first_without_area = 0, first_doubled = 0;

  std::size_t count() const { return without_area + doubled; }
  /// In words, or empty.
  std::string words() const;
};

/// Walls as they came, but for their corners, which are joined, and for facets that are left out:
/// without area, because a corner lies within the tolerance of another or of the side between the
/// two others, or with the corners of an earlier one, turned alike or not.
struct JoinedWalls {
  WeldedCorners welded;
  std::vector<int> source;  ///< number that each had in the walls given, from 0
  LeftOut left_out;

  Walls walls() const;
};

/// \param tolerance  see weld_corners [m]
/// \throws Error if the tolerance is larger than the triangles
JoinedWalls join_corners(const Walls& walls, double tolerance);

/// Triangles that meet have common corner numbers and whole common edges: where a corner lies on
/// the edge of another triangle, that triangle is cut there, so the way in which a file cuts a
/// surface does not matter.
struct WallMesh {
  Walls triangles;
  std::vector<std::array<int, 3>> corner;  ///< corner numbers of each triangle
  int corners = 0;
};

WallMesh cut_edges(JoinedWalls joined, double tolerance);

/// The tolerance for walls whose scene gives none: weld_share of the largest extent [m].
double weld_length(const Walls& walls);

/// Joined and cut.
WallMesh join_walls(const Walls& walls, double tolerance);
inline WallMesh join_walls(const Walls& walls) { return join_walls(walls, weld_length(walls)); }

/// A closed way along edges that belong to one triangle alone: the surface is open there.
struct WallRim {
  double length = 0;          ///< [m]
  Vec3 place = Vec3::Zero();  ///< one of its corners [m]
};

/// The shortest first.
std::vector<WallRim> open_rims(const WallMesh& mesh);

}  // namespace clogflow
