// Cuts a polygon into triangles.
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

namespace clogflow {

/// Triangles of a simple polygon as indices of its corners, counter-clockwise like the polygon.
/// They use no other points, so edges of neighbours meet whole; of all ears the fattest is cut
/// first.
/// \param corners  counter-clockwise [m]; consecutive edges may lie on one line
/// \throws Error when the polygon crosses itself
std::vector<std::array<int, 3>> triangulate(const std::vector<Eigen::Vector2d>& corners);

}  // namespace clogflow
