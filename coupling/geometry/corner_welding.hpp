// One number for corners of triangles that lie at the same place.
#pragma once

#include <array>
#include <vector>

#include "coupling/geometry/walls.hpp"

namespace clogflow {

/// Triangles by the numbers of their corners.
struct WeldedCorners {
  std::vector<Vec3> place;                 ///< of each corner: where the first of those that it joins lies [m]
  std::vector<std::array<int, 3>> corner;  ///< numbers of each triangle's corners
};

/// Joins corners that differ by at most `tolerance` in each coordinate, and what they are joined to
/// in turn: so it does not depend on the order of the triangles which corners become one. \param
/// tolerance  >= 0; below the rounding of the coordinates only equal corners are joined [m] \throws
/// Error if a chain of near corners is longer than three tolerances, or a thousand corners crowd
///         within eight: the tolerance is larger than the triangles
WeldedCorners weld_corners(const Walls& walls, double tolerance);

/// Largest extent of the walls along x, y or z [m]; 0 without walls.
double largest_extent(const Walls& walls);

}  // namespace clogflow
