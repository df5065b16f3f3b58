// Normal lubrication force between two nearly touching spheres.
#pragma once

#include <numbers>

#include "dem/physics/number.hpp"

namespace clogflow {

/// Resistance of the fluid film squeezed between two spheres, or a sphere and a wall (R* = r); the
/// leading term for small gaps, nothing tangential.
///   c = 6 pi eta R*^2 / h   (equal spheres of diameter d: 3 pi eta d^2 / (8 h))
/// The force on i is -c (n . (u_i - u_j)) n: it opposes approach and separation alike.
/// \param viscosity  eta [Pa s];  \param radius R* [m];  \param gap h > 0 [m]
/// \return c [N s/m]
/// \source paper Eq. (3); Batchelor & Green, J. Fluid Mech. 56 (1972) 375
template <class Real>
Real lubrication_coefficient(double viscosity, Real radius, Real gap) {
  return (6.0 * std::numbers::pi * viscosity) * radius * radius / gap;
}

/// Between which gaps there is a film, and what holds below.
struct LubricationLaw {
  double viscosity = 0;  ///< eta [Pa s]; 0: no lubrication
  double nearest = 0;    ///< 2 xi: below, the force is absent or held [m]
  double farthest = 0;   ///< [m]
  bool clamp = false;    ///< hold the force of `nearest` below it, down to contact

  /// Largest gap over R* where sizes differ, so that films reach in proportion to what they part; `farthest` is then
  /// that of the largest. 0: `farthest` for all [-]
  double per_radius = 0;

  /// Largest gap with a film between spheres of R* [m].
  template <class Real>
  Real reach(const Real& radius) const {
    return per_radius > 0 ? Real(per_radius) * radius : Real(farthest);
  }

  /// Smallest gap with a film [m].
  double least() const { return clamp ? 0 : nearest; }
};

/// Resistance of the film in a gap, by the law's window: 0 outside.
/// \param share  what the coefficient is divided by as well; a hot loop saves a division with it
/// \return c / share
template <class Real>
Real film_coefficient(const LubricationLaw& law, const Real& radius, const Real& gap, const Real& share) {
  const Real film = max(gap, Real(law.nearest));
  return select(gap <= law.reach(radius) && gap >= Real(law.least()),
                lubrication_coefficient(law.viscosity, radius, film * share), Real(0.0));
}

}  // namespace clogflow
