// Drag of the fluid on a particle in a suspension of given porosity.
#pragma once

#include <numbers>

#include "dem/physics/number.hpp"

namespace clogflow {

/// What is known of a particle's surroundings when its drag is asked for.
struct Surroundings {
  double porosity;  ///< eps [-], in (0, 1]
  double reynolds;  ///< rho eps |v - u| d / eta [-] >= 0, v the velocity between the particles
};

/// Drag of the fluid on a particle, equation (4) whole:
///   F = f 3 pi eta d (v - u)
/// \param coefficient  f 3 pi eta d [N s/m], f of a drag law;  \param fluid v;  \param particle u [m/s]
/// \return [N]
/// \source paper Eq. (4)
inline Vec3 drag_force(double coefficient, const Vec3& fluid, const Vec3& particle) {
  return {coefficient * (fluid.x - particle.x), coefficient * (fluid.y - particle.y),
          coefficient * (fluid.z - particle.z)};
}

/// Stokes' drag coefficient of a lone sphere, 3 pi eta d. \return [N s/m]
/// \source paper Eq. (4)
inline double stokes_coefficient(double viscosity, double diameter) {
  return 3.0 * std::numbers::pi * viscosity * diameter;
}

/// Stokes' torque coefficient of a lone sphere: torque = -pi eta d^3 (w - curl(V0) / 2).
/// \return [N m s]
inline double stokes_torque_coefficient(double viscosity, double diameter) {
  return std::numbers::pi * viscosity * diameter * diameter * diameter;
}

/// What the kick multiplies (F + c (v - u)) dt / m with when the drag is taken implicitly:
///   1 / (1 + dt c / m)
/// so that a stiff drag relaxes the particle to the fluid instead of overshooting.
template <class Real>
Real implicit_drag_factor(Real rate) {
  return Real(1.0) / (Real(1.0) + rate);
}

}  // namespace clogflow
