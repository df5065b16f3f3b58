// Sweeps: every combination of the values of some keys.
#pragma once

#include <string>
#include <vector>

#include "coupling/scene/scene.hpp"

namespace clogflow {

/// One combination: its folder and what it sets.
struct SweepPoint {
  std::string folder;   ///< "particles.diameter=33um" or "contact.friction.rolling=0.3,particles.diameter=33um"
  Overrides overrides;  ///< of the scene, one per sweep
};

/// All combinations of sweeps "key = value, value, ...": the last sweep varies fastest. Values are those of
/// --set; one that has commas of its own (a vector) cannot be swept. Without sweeps one point, whose folder
/// is empty.
/// \throws Error on a sweep without key or values, an unknown key, a key or a value given twice, or a value
/// that makes no name of a folder
std::vector<SweepPoint> sweep_points(const std::vector<std::string>& sweeps);

}  // namespace clogflow
