// Adhesion of soft elastic spheres: Johnson, Kendall and Roberts.
#pragma once

#include <numbers>

#include "dem/physics/number.hpp"

namespace clogflow {

/// Radius of the contact area of two adhesive spheres, on the branch that is stable when the overlap is held:
///   delta = a^2 / R* - sqrt(2 pi w a / E*)
/// With x = sqrt(a) this is x^4 - c x - D = 0, c = R* sqrt(2 pi w / E*), D = R* delta, solved by Ferrari: y is
/// the real root of y^3 + 4 D y - c^2 = 0, and x = (sqrt(y) + sqrt(2 c / sqrt(y) - y)) / 2.
/// \param overlap  delta [m], >= -jkr_reach()
/// \param adhesion c [m^(3/2)] > 0 (jkr_adhesion)
/// \return a [m]
/// \source Johnson, Kendall & Roberts, Proc. R. Soc. A 324 (1971) 301; K. L. Johnson, Contact Mechanics,
///         sec. 5.5
template <class Real>
Real jkr_contact_radius(const Real& overlap, const Real& radius, const Real& adhesion) {
  const Real square = adhesion * adhesion, third = (4.0 / 3.0) * radius * overlap;
  // Rounding must not make the root imaginary at the last overlap of the branch.
  const Real root = sqrt(max(Real(0.0), 0.25 * square * square + third * third * third));
  const Real a = cbrt(0.5 * square + root);
  // The other cube root, without the difference of two large numbers.
  const Real b = third / a;
  const Real y = square / (a * a + third + b * b);
  const Real slope = sqrt(y);
  const Real x = 0.5 * (slope + sqrt(max(Real(0.0), 2.0 * adhesion / slope - y)));
  return x * x;
}

/// c of jkr_contact_radius: R* sqrt(2 pi w / E*) [m^(3/2)].
template <class Real>
Real jkr_adhesion(double surface_energy, double modulus, const Real& radius) {
  return Real(sqrt(2 * std::numbers::pi * surface_energy / modulus)) * radius;
}

/// Force at a contact radius: F = 4 E* a^3 / (3 R*) - sqrt(8 pi w E* a^3), repulsive positive.
/// \return [N]
/// \source Johnson, Kendall & Roberts (1971); Johnson, Contact Mechanics, Eq. (5.48)
template <class Real>
Real jkr_force(double surface_energy, double modulus, const Real& radius, const Real& contact_radius) {
  const Real cube = contact_radius * contact_radius * contact_radius;
  return (4.0 / 3.0 * modulus) * cube / radius - sqrt(Real(8 * std::numbers::pi * surface_energy * modulus) * cube);
}

/// Largest force that pulls without parting the spheres: 3/2 pi w R* [N].
template <class Real>
Real jkr_pull_off(double surface_energy, const Real& radius) {
  return Real(1.5 * std::numbers::pi * surface_energy) * radius;
}

/// How far the spheres must be apart before the contact breaks when their distance is held:
///   (3/4) (pi^2 w^2 R* / E*^2)^(1/3)
/// \return [m], a gap
/// \source Johnson, Contact Mechanics, sec. 5.5: the end of the branch d delta / d a = 0
template <class Real>
Real jkr_reach(double surface_energy, double modulus, const Real& radius) {
  const double share = std::numbers::pi * surface_energy / modulus;
  return 0.75 * cbrt(Real(share * share) * radius);
}

}  // namespace clogflow
