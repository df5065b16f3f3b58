// The walls of the parametric channel: their outline, and as triangles.
#pragma once

#include <vector>

#include "coupling/channel_shape.hpp"
#include "coupling/scene.hpp"
#include "coupling/walls.hpp"

namespace clog {

/// Corners of the two side walls from inlet to outlet, arcs cut into flat pieces [m].
struct ChannelOutline {
  std::vector<Vec2> upper, lower;  ///< y > 0, y < 0
};
ChannelOutline channel_outline(const Scene& scene);

/// Side walls, floor z = 0 and lid z = neck_height from the inlet to the outlet, which stay open.
/// Triangles share whole edges (no corner lies inside another's edge), so an edge belongs to two
/// triangles or lies on an opening.
/// \throws Error when the scene has no geometry section
Walls channel_walls(const Scene& scene);

}  // namespace clog
