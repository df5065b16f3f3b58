// Where a study does not speak for a scene: physics that it had otherwise.
#pragma once

#include <string>
#include <string_view>

#include "coupling/scene/scene.hpp"

namespace clogflow::trade {

/// Keys of physics in which a scene differs from that of a study, each with both values; nothing where there are none.
/// Left out is what studies are there to compare (diameter and what goes with it, stiffness, mass, step) and what only
/// sets the scale (lengths other than the angle, fluid, rate). \param studied  its scene, as effective_scene() made it
/// \param but  beginning of keys that may differ, too
std::string unlike(const std::string& studied, const Scene& scene, std::string_view but = {});

}  // namespace clogflow::trade
