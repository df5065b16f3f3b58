// Two spheres, or a sphere and a wall, as their contact sees them: the only place where the geometry of a
// contact is built.
#pragma once

#include "dem/physics/number.hpp"

namespace clogflow {

/// What two bodies have in common when each resists on its own: R* of two radii, m* of two masses.
///   a b / (a + b)
/// A wall counts as infinite: its partner's own value.
/// \source paper, text below Eq. (1)
template <class Real>
Real reduced(const Real& a, const Real& b) {
  return a * b / (a + b);
}

template <class Real>
struct ContactGeometry {
  Vector<Real> normal;  ///< n, from j (or the wall) to i [-]
  Real overlap;         ///< delta > 0 [m]
  Real radius;          ///< R* [m]
  Real mass;            ///< m* [kg]
  Real arm_i, arm_j;    ///< from the centres to the contact point [m]; 0 for a wall
  /// 1 / D of the centres' distance, by which the normal turns while they move; 0: a normal that does not turn, or
  /// whose turning within a step is neglected [1/m]
  Real turning = Real(0.0);
};

template <class Real>
struct ContactMotion {
  Vector<Real> velocity;        ///< u_i - u_j of the centres [m/s]
  Vector<Real> spin_i, spin_j;  ///< [rad/s]
};

template <class Real>
struct ContactLoads {
  Vector<Real> force;               ///< on i; j gets the opposite [N]
  Vector<Real> torque_i, torque_j;  ///< [N m]
};

/// The springs of a contact, remembered from step to step [m].
template <class Real>
struct Springs {
  Vector<Real> sliding, rolling;
  Real torsion;  ///< along the normal
};

/// Places of two spheres and their sizes.
template <class Real>
struct PairPlace {
  Vector<Real> apart;  ///< x_i - x_j [m]
  Real radius_i, radius_j;

  Real distance() const { return sqrt(distance2()); }
  Real distance2() const { return dot(apart, apart); }

  /// Above zero where the spheres overlap. One expression for all who ask, so that they agree to the bit.
  Real overlap(const Real& distance) const { return radius_i + radius_j - distance; }

  Real effective_radius() const { return reduced(radius_i, radius_j); }

  /// The contact, whose point lies in the middle of the overlap: so the arms sum up to the distance.
  /// \param normal   apart / distance, which who asks has at hand
  /// \param overlap  as the law may be given it: not below the least at which it acts [m]
  /// \param mass     m* [kg]
  ContactGeometry<Real> contact(const Vector<Real>& normal, const Real& overlap, const Real& mass) const {
    const Real half(0.5);
    return {normal, overlap, effective_radius(), mass, radius_i - half * overlap, radius_j - half * overlap};
  }
};

/// A sphere pressed into a wall that is flat as far as the contact reaches; the wall has no arm and no end
/// of mass.
template <class Real>
ContactGeometry<Real> wall_contact(const Vector<Real>& normal, const Real& overlap, const Real& radius,
                                   const Real& mass) {
  return {normal, overlap, radius, mass, radius - Real(0.5) * overlap, Real(0.0)};
}

}  // namespace clogflow
