// Forces that come from neither neighbours nor fluid.
#pragma once

#include "coupling/scene/scene.hpp"
#include "dem/kernels/kernels.hpp"
#include "dem/physics/weight.hpp"
#include "dem/state/particles.hpp"

namespace clogflow {

/// Weight per mass [m/s2] along axis a.
inline double weight_per_mass(const Scene& s, int a) {
  return weight_per_mass(s.gravity[a], s.particles.density, s.fluid.density, s.time.mass_scale);
}

/// body_force and weight. [N]
inline Vector<double> external_force(const Scene& s, double mass) {
  const auto& body = s.body_force;
  return {body[0] + mass * weight_per_mass(s, 0), body[1] + mass * weight_per_mass(s, 1),
          body[2] + mass * weight_per_mass(s, 2)};
}

}  // namespace clogflow
