// One contact, whole: the normal force, then sliding, rolling and torsion limited by it.
#pragma once

#include <cmath>

#include "dem/physics/hertz.hpp"
#include "dem/physics/material_pair.hpp"
#include "dem/physics/rolling_torsion.hpp"
#include "dem/physics/sliding.hpp"

namespace clog {

/// Constants of one kind of contact (particle-particle or particle-wall).
struct ContactLaw {
  double modulus = 0;            ///< E* [Pa]
  double shear_modulus = 0;      ///< G* [Pa]
  double tangential_factor = 0;  ///< [-]
  double gamma = 0;              ///< normal damping constant [-]
  double tangential_damping = 0; ///< tangential over normal dashpot coefficient [-]
  double sliding_friction = 0;   ///< mu [-]
  double rolling_friction = 0;   ///< [-]
  double torsion_friction = 0;   ///< [-]
  double torsion_memory = 1;     ///< 1: objective; 2: the spring doubles every step, an experiment
};

/// Which springs exist; a term whose friction is zero is not even compiled in.
struct ContactTerms {
  bool sliding, rolling, torsion;
};

/// The springs of a contact, remembered from step to step [m].
template <class Real>
struct Springs {
  Vector<Real> sliding, rolling;
  Real torsion;  ///< along the normal
};

template <class Real>
struct ContactGeometry {
  Vector<Real> normal;  ///< n, from j (or the wall) to i [-]
  Real overlap;         ///< delta > 0 [m]
  Real radius;          ///< R* [m]
  Real mass;            ///< m* [kg]
  Real arm_i, arm_j;    ///< from the centres to the contact point [m]; 0 for a wall
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

/// Forces and torques of one contact, and its springs one step on. The arms sum up to the distance
/// of the centres, so linear and angular momentum are conserved exactly.
/// \param springs  of the last step; zero for a new contact; updated
template <ContactTerms terms, class Real>
ContactLoads<Real> contact_loads(const ContactLaw& law, const ContactGeometry<Real>& g,
                                 const ContactMotion<Real>& m, double dt, Springs<Real>& springs) {
  const Real root = sqrt(g.radius * g.overlap);
  const Real stiffness = hertz_stiffness(law.modulus, root);
  const Real dashpot = dashpot_coefficient(law.gamma, stiffness, g.mass);
  const Real approach = dot(m.velocity, g.normal);
  const Real normal = normal_force(stiffness * g.overlap, dashpot, approach);

  ContactLoads<Real> loads{normal * g.normal, {}, {}};
  loads.torque_i = loads.torque_j = Vector<Real>{Real(0.0), Real(0.0), Real(0.0)};
  if constexpr (!terms.sliding && !terms.rolling && !terms.torsion) return loads;

  const Real spring_stiffness = mindlin_stiffness(law.tangential_factor, law.shear_modulus, root);
  const Real spring_dashpot = law.tangential_damping * dashpot;
  const auto slider = [&](double friction) {
    return SliderParameters<Real>{spring_stiffness, spring_dashpot, friction * normal, dt};
  };
  const Vector<Real> spin = m.spin_i - m.spin_j;
  if constexpr (terms.sliding) {
    const Vector<Real> lever = g.arm_i * m.spin_i + g.arm_j * m.spin_j;
    const Vector<Real> velocity =
        m.velocity - approach * g.normal - cross(lever, g.normal);
    const auto [spring, force] = spring_slider(turn_into_plane(springs.sliding, g.normal), velocity,
                                               slider(law.sliding_friction));
    springs.sliding = spring;
    loads.force = loads.force + force;
    const Vector<Real> turn = cross(force, g.normal);
    loads.torque_i = g.arm_i * turn;
    loads.torque_j = g.arm_j * turn;
  }
  Vector<Real> couple{Real(0.0), Real(0.0), Real(0.0)};
  if constexpr (terms.rolling) {
    const auto [spring, force] =
        spring_slider(turn_into_plane(springs.rolling, g.normal),
                      rolling_velocity(g.radius, g.normal, spin), slider(law.rolling_friction));
    springs.rolling = spring;
    couple = rolling_torque(g.radius, g.normal, force);
  }
  if constexpr (terms.torsion) {
    const auto [spring, force] =
        spring_slider(Real(law.torsion_memory) * springs.torsion,
                      torsion_velocity(g.radius, g.normal, spin), slider(law.torsion_friction));
    springs.torsion = spring;
    couple = couple + torsion_torque(g.radius, force) * g.normal;
  }
  loads.torque_i = loads.torque_i + couple;
  loads.torque_j = loads.torque_j - couple;
  return loads;
}

/// Energy stored in a contact: 2/5 k delta^2 of the Hertz spring and k_t/2 of each other spring.
/// \return [J]
inline double stored_energy(const ContactLaw& law, const ContactGeometry<double>& g,
                            const Springs<double>& s) {
  const double root = std::sqrt(g.radius * g.overlap);
  const double spring_stiffness = mindlin_stiffness(law.tangential_factor, law.shear_modulus, root);
  return 0.4 * hertz_stiffness(law.modulus, root) * g.overlap * g.overlap +
         0.5 * spring_stiffness *
             (dot(s.sliding, s.sliding) + dot(s.rolling, s.rolling) + s.torsion * s.torsion);
}

}  // namespace clog
