// Rolling and torsion: pseudo-velocities whose spring-sliders give torques.
#pragma once

#include "dem/physics/number.hpp"

namespace clogflow {

/// Rolling velocity of two spheres, objective: zero when both turn as one rigid body does.
///   v_r = -R* n x (w_i - w_j)
/// \param radius  R*, 1/R* = 1/r_i + 1/r_j [m];  \param normal n, from j to i [-]
/// \param spin    w_i - w_j [rad/s]
/// \return [m/s]
/// \source Luding, Granular Matter 10 (2008) 235, Eq. (14)
template <class Real>
Vector<Real> rolling_velocity(Real radius, const Vector<Real>& normal, const Vector<Real>& spin) {
  return -(radius * cross(normal, spin));
}

/// Torque on i of the rolling pseudo-force; j gets the opposite. No force results.
///   q_i = R* n x f_r
/// \return [N m]
/// \source Luding (2008), Eq. (16)
template <class Real>
Vector<Real> rolling_torque(Real radius, const Vector<Real>& normal, const Vector<Real>& force) {
  return radius * cross(normal, force);
}

/// Torsion velocity, along n: v_o = 2 R* n . (w_i - w_j).
/// \return [m/s]
/// \source Luding (2008), sec. 3.4, with the length 2 R* of MercuryDPM
template <class Real>
Real torsion_velocity(Real radius, const Vector<Real>& normal, const Vector<Real>& spin) {
  return Real(2.0) * radius * dot(normal, spin);
}

/// Torque on i about n of the torsion pseudo-force: q_i = 2 R* f_o n.
/// \return the component along n [N m]
template <class Real>
Real torsion_torque(Real radius, Real force) {
  return Real(2.0) * radius * force;
}

}  // namespace clogflow
