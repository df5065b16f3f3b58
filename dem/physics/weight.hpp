// Weight of a sphere in a fluid, less its buoyancy.
#pragma once

namespace clogflow {

/// What gravity does to a particle, per mass that the solver moves it with:
///   F / m = g (1 - rho_f / rho_p) / s,    m = s rho_p V
/// so that F = (rho_p - rho_f) V g whatever the mass scale s. Neglects that the fluid between particles is lighter or
/// heavier than the suspension: each displaces fluid, as a lone sphere does.
/// \param gravity g [m/s2];  \param fluid_density  0: no fluid [kg/m3];  \return [m/s2]
/// \source Archimedes; Stokes' settling velocity (rho_p - rho_f) g d^2 / (18 eta) follows with drag_force()
inline double weight_per_mass(double gravity, double density, double fluid_density, double mass_scale) {
  return gravity * (1 - fluid_density / density) / mass_scale;
}

}  // namespace clogflow
