// Corners that lie on an edge between two other corners, and triangles cut at them.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "coupling/geometry/corner_welding.hpp"
#include "coupling/geometry/walls.hpp"

namespace clogflow {

/// A corner inside an edge.
struct HangingCorner {
  int number;
  double share;  ///< of the way along the edge, in (0, 1)
};

/// The corners that hang on each side (3 t + k) of the triangles, in the order of the way along it.
using HangingCorners = std::unordered_map<std::uint32_t, std::vector<HangingCorner>>;

/// Whether p lies on the edge from a to b: farther than the tolerance from both ends along it, and
/// no coordinate farther than that beside it. \return its share of the way, or 0
double share_on_edge(const Vec3& a, const Vec3& b, const Vec3& p, double tolerance);

/// Only edges that no second triangle uses the other way can have one, and only the ends of such
/// edges hang.
HangingCorners find_hanging(const WeldedCorners& welded, double tolerance);

/// Cuts triangle t of the welded ones at its hanging corners and appends the pieces. They lie in
/// its plane: the cuts are on its edges. Each corner is used once, so there are as many pieces as
/// hanging corners, and one. \param hanging  on each of the three sides
void append_cut(const WeldedCorners& welded, std::size_t t, const std::array<std::vector<HangingCorner>, 3>& hanging,
                std::vector<Triangle>& triangles, std::vector<std::array<int, 3>>& corner);

}  // namespace clogflow
