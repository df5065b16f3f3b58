// The walls of the parametric channel: their outline, and as triangles.
#pragma once

#include <vector>

#include "coupling/geometry/channel_shape.hpp"
#include "coupling/geometry/geometry.hpp"
#include "coupling/geometry/walls.hpp"

namespace clogflow {

/// Corners of the two side walls from inlet to outlet, arcs cut into flat pieces [m].
struct ChannelOutline {
  std::vector<Vec2> upper, lower;  ///< y > 0, y < 0
};
ChannelOutline channel_outline(const Geometry& geometry);

/// Side walls, floor z = 0 and lid z = neck_height from the inlet to the outlet, which stay open.
/// Triangles share whole edges (no corner lies inside another's edge), so an edge belongs to two
/// triangles or lies on an opening.
/// \throws Error when the scene has no geometry section
Walls channel_walls(const Geometry& geometry);

}  // namespace clogflow
