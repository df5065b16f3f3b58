// Normal lubrication force between two nearly touching spheres.
#pragma once

#include <numbers>

#include "dem/physics/number.hpp"

namespace clog {

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

}  // namespace clog
