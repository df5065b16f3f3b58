// Drag of the fluid on a particle in a suspension of given porosity.
#pragma once

#include <numbers>

#include "dem/physics/number.hpp"

namespace clog {

/// Ratio of the drag in a random pack of equal spheres to that on a lone sphere, at Re -> 0.
///   f(eps) = 10 (1 - eps) / eps^2 + eps^2 (1 + 1.5 sqrt(1 - eps))
/// \param porosity  eps [-], in (0, 1]
/// \return [-]; 1 at eps = 1
/// \source paper, text below Eq. (4); van der Hoef, Beetstra & Kuipers, J. Fluid Mech. 528 (2005) 233
template <class Real>
Real voidage_function(Real porosity) {
  const Real solid = Real(1.0) - porosity;
  const Real square = porosity * porosity;
  return Real(10.0) * solid / square + square * (Real(1.0) + Real(1.5) * sqrt(solid));
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

}  // namespace clog
