// The walls of the parametric channel as triangles.
#pragma once

#include "coupling/scene.hpp"
#include "coupling/walls.hpp"

namespace clog {

/// Side walls, slanted walls, neck walls, floor z = 0 and lid z = neck_height from the start of the
/// channel to the end of the neck; inlet and outlet stay open. Triangles share whole edges (no
/// corner lies inside another's edge), so an edge belongs to two triangles or lies on an opening.
/// \throws Error when the scene has no geometry section
Walls channel_walls(const Scene& scene);

}  // namespace clog
