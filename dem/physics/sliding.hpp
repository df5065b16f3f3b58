// Tangential contact force: a Mindlin spring with a dashpot, cut back at the Coulomb limit. The same
// spring-slider serves sliding, rolling and torsion.
#pragma once

#include <limits>

#include "dem/physics/number.hpp"

namespace clogflow {

/// Tangential stiffness of a Hertz contact (Mindlin, no slip annulus), times a scene's factor.
///   k_t = factor 8 G* sqrt(R* delta)
/// \param factor         2/3 as in MercuryDPM (Di Maio & Di Renzo 2005), 1 as in LAMMPS and LIGGGHTS
/// \param shear_modulus  G* effective shear modulus [Pa]
/// \param root           sqrt(R* delta) [m]
/// \return [N/m]
/// \source Di Renzo & Di Maio, Chem. Eng. Sci. 60 (2005) 1303
template <class Real>
Real mindlin_stiffness(double factor, double shear_modulus, Real root) {
  return (factor * 8.0 * shear_modulus) * root;
}

/// Turns a spring into the present contact plane with its length kept.
/// \param spring  s of the last step [m]
/// \param normal  n [-]
/// \return s, perpendicular to n [m]; zero if s was parallel to n
template <class Real>
Vector<Real> turn_into_plane(const Vector<Real>& spring, const Vector<Real>& normal) {
  const Real along = dot(spring, normal);
  const Vector<Real> flat = spring - along * normal;
  const Real before = dot(spring, spring);
  // A pack at rest turns by less than rounding: the root and the division would change nothing.
  if (!any_of(along * along > Real(std::numeric_limits<double>::epsilon()) * before)) return flat;
  const Real after = dot(flat, flat);
  const auto turnable = after > Real(0.0);
  const Real scale = select(turnable, sqrt(before / select(turnable, after, Real(1.0))), Real(0.0));
  return scale * flat;
}

template <class Real, class Value>
struct SpringSlider {
  Value spring;  ///< s after the step [m]
  Value force;   ///< [N]
};

template <class Real>
struct SliderParameters {
  Real stiffness;  ///< k [N/m] > 0
  Real dashpot;    ///< c [N s/m]
  Real limit;      ///< L = mu F_n [N] >= 0
  double dt;       ///< [s]
};

/// One step of a spring-slider-dashpot: the spring grows by v dt and is cut back so that k |s| never
/// exceeds the limit; the dashpot is added before the total is limited, so friction never exceeds
/// Coulomb's law. No length threshold: works at 1e-12 m as at 1 m.
///   s <- s + v dt, |s| <= L / k;   f = -k s - c v, |f| <= L
/// \param spring    s, already in the contact plane [m]
/// \param velocity  v, relative velocity at the contact [m/s]
/// \return the spring after the step [m] and the force on the first particle [N]
/// \source Cundall & Strack, Geotechnique 29 (1979) 47; Luding, Granular Matter 10 (2008) 235, sec. 3.2
template <class Real>
SpringSlider<Real, Vector<Real>> spring_slider(const Vector<Real>& spring, const Vector<Real>& velocity,
                                               const SliderParameters<Real>& p) {
  Vector<Real> s = spring + Real(p.dt) * velocity;
  const Real stretch = p.stiffness * p.stiffness * dot(s, s);
  const Real limit2 = p.limit * p.limit;
  // Few contacts of a pack at rest slip, and roots and divisions cost more than all the rest.
  const auto slips = stretch > limit2;
  if (any_of(slips)) s = select(slips, p.limit / sqrt(select(slips, stretch, Real(1.0))), Real(1.0)) * s;
  Vector<Real> f = -(p.stiffness * s) - p.dashpot * velocity;
  const Real size = dot(f, f);
  const auto exceeds = size > limit2;
  if (any_of(exceeds)) f = select(exceeds, p.limit / sqrt(select(exceeds, size, Real(1.0))), Real(1.0)) * f;
  return {s, f};
}

/// The same along one direction, for torsion about the contact normal.
template <class Real>
SpringSlider<Real, Real> spring_slider(Real spring, Real velocity, const SliderParameters<Real>& p) {
  Real s = spring + Real(p.dt) * velocity;
  const Real stretch = p.stiffness * s;
  if (any_of(stretch > p.limit || -stretch > p.limit)) {
    const Real longest = p.limit / p.stiffness;
    s = max(-longest, min(longest, s));
  }
  const Real f = max(-p.limit, min(p.limit, -(p.stiffness * s) - p.dashpot * velocity));
  return {s, f};
}

}  // namespace clogflow
