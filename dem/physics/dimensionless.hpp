// Dimensionless numbers that decide which physics a scene needs.
#pragma once

#include <cmath>
#include <numbers>

#include "dem/physics/drag.hpp"
#include "dem/physics/porosity.hpp"

namespace clogflow {

/// A sphere in a fluid.
struct SphereInFluid {
  double diameter;       ///< d [m]
  double density;        ///< of the sphere [kg/m3]
  double fluid_density;  ///< [kg/m3]
  double viscosity;      ///< eta [Pa s]
};

/// rho v L / eta: inertia of the fluid over its viscosity.
inline double reynolds_number(double density, double speed, double length, double viscosity) {
  return density * speed * length / viscosity;
}

struct Liquid {
  double density, viscosity;  ///< [kg/m3], [Pa s]
};

/// Womersley's number on the half height: whether a flow between plates keeps its steady profile while its rate
/// oscillates, (H/2) sqrt(2 pi f rho / eta); it does well below 1. [-]
inline double womersley_number(const Liquid& l, double frequency, double height) {
  return height / 2 * std::sqrt(2 * std::numbers::pi * frequency * l.density / l.viscosity);
}

/// Frequency at which it is 1 [Hz].
inline double quasi_steady_until(const Liquid& l, double height) {
  return 2 * l.viscosity / (std::numbers::pi * l.density * height * height);
}

/// Time in which drag makes a sphere follow the fluid: m / (3 pi eta d f) [s].
/// \param voidage  f(eps) [-]
inline double response_time(const SphereInFluid& s, double voidage) {
  return s.density * sphere_volume(s.diameter / 2) / (stokes_coefficient(s.viscosity, s.diameter) * voidage);
}

inline constexpr double standard_gravity = 9.80665;  ///< [m/s2]

/// Stokes velocity of a heavy or light sphere over the flow's: |rho_p - rho_f| g d^2 / (18 eta v).
inline double settling_ratio(const SphereInFluid& s, double speed, double gravity = standard_gravity) {
  return std::abs(s.density - s.fluid_density) * gravity * s.diameter * s.diameter / (18 * s.viscosity * speed);
}

/// Advection over Brownian diffusion: v d / (k T / (3 pi eta d)), at 293 K.
inline double peclet_number(const SphereInFluid& s, double speed) {
  constexpr double thermal_energy = 1.380649e-23 * 293;  // [J]
  return speed * s.diameter * stokes_coefficient(s.viscosity, s.diameter) / thermal_energy;
}

/// Inertia of an impact over the fluid film's resistance: St = m* v / (6 pi eta R*^2) for two equal
/// spheres. Below about 10 the film takes all the energy and the dry restitution does not matter.
/// \source Gondret, Lance & Petit, Phys. Fluids 14 (2002) 643
inline double collision_stokes_number(const SphereInFluid& s, double speed) {
  const double mass = s.density * sphere_volume(s.diameter / 2) / 2, radius = s.diameter / 4;
  return mass * speed / (6 * std::numbers::pi * s.viscosity * radius * radius);
}

/// Adhesion over drag: the force that parts two spheres over Stokes' drag 3 pi eta d v of one. In a pack drag is
/// f(eps) / eps times larger, in an arch the drag of many presses on each contact.
/// \param pull_off  [N]: jkr_pull_off, Dmt::pull_off
inline double adhesion_number(double pull_off, const SphereInFluid& s, double speed) {
  return pull_off / (stokes_coefficient(s.viscosity, s.diameter) * speed);
}

/// Tabor's number, the neck that adhesion pulls over the reach of the forces between surfaces:
///   mu_T = (R* w^2 / (E*^2 z0^3))^(1/3),  z0 = 0.165 nm
/// \param surface_energy  w [J/m2];  \param modulus E* [Pa];  \param radius R* [m]
/// \source D. Tabor, J. Colloid Interface Sci. 58 (1977) 2; z0: Israelachvili, Intermolecular and Surface Forces
inline double tabor_number(double surface_energy, double modulus, double radius) {
  constexpr double distance = 0.165e-9;  // z0 [m]
  const double strain = surface_energy / modulus;
  return std::cbrt(radius * strain * strain) / distance;
}

/// Tabor's number above which spheres stick as law jkr says, and below which as law dmt does.
/// \source the map of Johnson & Greenwood, J. Colloid Interface Sci. 192 (1997) 326
inline constexpr double jkr_from = 5, dmt_until = 0.1;

}  // namespace clogflow
