// Normal contact force: Hertz with a dashpot.
#pragma once

#include <cmath>

#include "dem/physics/number.hpp"

namespace clogflow {

/// Secant stiffness of a Hertz contact, so that F = k delta; no adhesion, no plasticity.
///   k = 4/3 E* sqrt(R* delta)
/// \param modulus   E* effective modulus [Pa] > 0
/// \param root      sqrt(R* delta), the radius of the contact area [m] >= 0
/// \return k [N/m]; 0 at zero overlap
/// \source paper Eq. (1), F = 4/3 E* sqrt(R*) delta^(3/2); K. L. Johnson, Contact Mechanics, ch. 4
template <class Real>
Real hertz_stiffness(double modulus, Real root) {
  return (4.0 / 3.0 * modulus) * root;
}

/// Coefficient of the dashpot, gamma sqrt(m* k).
/// \param gamma      damping constant [-] (damping_constant)
/// \param stiffness  k [N/m]
/// \param mass       m* effective mass [kg]
/// \return [N s/m]
/// \source Antypov & Elliott, EPL 94 (2011) 50004; Tsuji, Tanaka & Ishida, Powder Technol. 71 (1992) 239
template <class Real>
Real dashpot_coefficient(double gamma, Real stiffness, Real mass) {
  return gamma * sqrt(mass * stiffness);
}

/// Normal force of spring and dashpot, never attractive: a dry contact cannot pull.
///   F_n = max(0, k delta - c v_n)
/// \param elastic   k delta [N]
/// \param dashpot   c [N s/m]
/// \param speed     v_n, rate at which the centres separate [m/s]
/// \return F_n [N], repulsive positive
template <class Real>
Real normal_force(Real elastic, Real dashpot, Real speed) {
  return max(Real(0.0), elastic - dashpot * speed);
}

/// Overlap of a Hertz contact under a force: (3 F / (4 E* sqrt(R*)))^(2/3) [m].
/// \source inverse of paper Eq. (1)
inline double hertz_overlap(double force, double modulus, double radius) {
  return std::pow(3 * force / (4 * modulus * std::sqrt(radius)), 2.0 / 3.0);
}

}  // namespace clogflow
