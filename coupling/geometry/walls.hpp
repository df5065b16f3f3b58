// Walls as triangles: what the flow file carries and the particle solver collides with.
#pragma once

#include <array>
#include <vector>

#include "coupling/base/vector.hpp"

namespace clogflow {

/// One flat piece of wall; counter-clockwise seen from the fluid, so its normal points into it.
struct Triangle {
  std::array<Vec3, 3> corner;  ///< [m]
};

using Walls = std::vector<Triangle>;

}  // namespace clogflow
