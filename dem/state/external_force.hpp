// Forces that come from neither neighbours nor fluid flow: weight less buoyancy, and the scene's body_force.
#pragma once

#include <algorithm>
#include <numbers>

#include "coupling/scene/scene.hpp"
#include "dem/physics/number.hpp"

namespace clogflow {

/// What gravity does to a particle, per mass that the solver moves it with:
///   F / m = g (1 - rho_f / rho_p) / s,    m = s rho_p V
/// so that F = (rho_p - rho_f) V g whatever the mass scale s. Neglects that a suspension is lighter or heavier than its
/// fluid: each particle displaces fluid, as a lone sphere does. Without a fluid rho_f = 0.
/// \param gravity  g [m/s2]  \return [m/s2]
/// \source Archimedes; with drag_force() Stokes' settling velocity (rho_p - rho_f) g d^2 / (18 eta) follows
/// \param density  rho_p [kg/m3]
inline double weight_per_mass(const Scene& s, double gravity, double density) {
  return gravity * (1 - s.fluid.density / density) / s.time.mass_scale;
}

/// Whether particles of one scene differ in density.
inline bool mixes_densities(const Scene& s) {
  return std::ranges::any_of(s.particles.species, [](const Species& kind) { return kind.density > 0; });
}

/// Weight of the fluid that a sphere displaces, per cubed radius [N/m3]
inline double buoyancy_per_cube(const Scene& s, double gravity) {
  return 4.0 / 3.0 * std::numbers::pi * s.fluid.density * gravity;
}

/// \param mass  that the solver moves the particle with [kg];  \param radius [m], which matters where densities differ
/// \return [N]
inline Vec3 external_force(const Scene& s, double mass, double radius) {
  const auto& [bx, by, bz] = s.body_force;
  const auto& [gx, gy, gz] = s.gravity;
  const double density = mixes_densities(s)
                             ? mass / (s.time.mass_scale * 4.0 / 3.0 * std::numbers::pi * radius * radius * radius)
                             : s.particles.density;
  const auto weight = [&](double g) { return mass * weight_per_mass(s, g, density); };
  return {bx + weight(gx), by + weight(gy), bz + weight(gz)};
}

}  // namespace clogflow
