// Forces that come from neither neighbours nor fluid flow: weight less buoyancy, and the scene's body_force.
#pragma once

#include "coupling/scene/scene.hpp"
#include "dem/physics/number.hpp"

namespace clogflow {

/// What gravity does to a particle, per mass that the solver moves it with:
///   F / m = g (1 - rho_f / rho_p) / s,    m = s rho_p V
/// so that F = (rho_p - rho_f) V g whatever the mass scale s. Neglects that a suspension is lighter or heavier than its
/// fluid: each particle displaces fluid, as a lone sphere does. Without a fluid rho_f = 0.
/// \param gravity  g [m/s2]  \return [m/s2]
/// \source Archimedes; with drag_force() Stokes' settling velocity (rho_p - rho_f) g d^2 / (18 eta) follows
inline double weight_per_mass(const Scene& s, double gravity) {
  return gravity * (1 - s.fluid.density / s.particles.density) / s.time.mass_scale;
}

/// \param mass  that the solver moves the particle with [kg]  \return [N]
inline Vec3 external_force(const Scene& s, double mass) {
  const auto& [bx, by, bz] = s.body_force;
  const auto& [gx, gy, gz] = s.gravity;
  return {bx + mass * weight_per_mass(s, gx), by + mass * weight_per_mass(s, gy), bz + mass * weight_per_mass(s, gz)};
}

}  // namespace clogflow
