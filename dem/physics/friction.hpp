// What a contact adds to its normal force: sliding, rolling and torsion, each limited by the grip that
// the normal law gives.
#pragma once

#include <limits>
#include <string_view>

#include "dem/physics/contact_geometry.hpp"
#include "dem/physics/rolling_torsion.hpp"
#include "dem/physics/sliding.hpp"

namespace clogflow {

/// Which springs exist; a term whose friction is zero is not even compiled in.
struct ContactTerms {
  bool sliding, rolling, torsion;
  bool midway = false;  ///< sliding by the normal of the time of the velocities, see sliding_velocity()

  bool any() const { return sliding || rolling || torsion; }
};

/// Coefficient between two surfaces of different friction: the harmonic mean 2 a b / (a + b), 0 if either is 0. A rule
/// of DEM codes, not a law of nature: where the pair was measured, no rule is needed.
/// \source MercuryDPM, BaseSpecies::average, by which MindlinSpecies::mix and the like mix coefficients
inline double mixed_friction(double a, double b) {
  if (a == b) return a;
  return a > 0 && b > 0 ? 2 * a * b / (a + b) : 0;
}

/// Doubles in a row of coefficients: sliding, rolling, torsion, none.
inline constexpr int friction_row = 4;

/// Coulomb coefficients of one kind of contact.
struct FrictionLaw {
  double sliding = 0;  ///< mu, the largest where species differ [-]
  double rolling = 0;  ///< likewise [-]
  double torsion = 0;  ///< likewise [-]
  /// Contacts farther downstream have none: where a release ends [m]
  double ends = std::numeric_limits<double>::infinity();

  const double* of_species =
      nullptr;       ///< a row for each pair of species, if they differ: dem/contact/species_friction.hpp
  int partners = 1;  ///< species of the second, 1 for walls

  bool ends_somewhere() const { return ends < std::numeric_limits<double>::infinity(); }

  /// Of particles of these species. \param second  0 for a wall
  FrictionLaw between(int first, int second) const {
    if (!of_species) return *this;
    const double* row = of_species + friction_row * (first * partners + second);
    return {row[0], row[1], row[2], ends};
  }
};

/// What a normal law tells at one overlap; all that friction needs to know of it.
template <class Real>
struct NormalResponse {
  Real force;      ///< on i along n: repulsive positive [N]
  Real grip;       ///< load that friction is limited by [N] >= 0
  Real stiffness;  ///< of the sliding spring [N/m]
  Real dashpot;    ///< beside it [N s/m]
};

/// What the step limit needs to know of a normal law at one overlap.
struct NormalTangent {
  double stiffness;  ///< dF/d delta, or a bound of it [N/m]
  double dashpot;    ///< [N s/m]
};

/// How springs of rolling and torsion are made, beside the sliding spring.
///   rolling_lever      pseudo-velocity and torque have the lever rolling_lever R* [-]
///   full_stiffness     their springs are as stiff as without the scene's tangential factor
///   torsion_memory     share of the torsion spring that is kept from step to step [-]

/// Luding (2008): the default.
struct LudingTurning {
  static constexpr std::string_view word = "luding";
  static constexpr double rolling_lever = 1;
  static constexpr bool full_stiffness = false;
  static constexpr double torsion_memory = 1;
};

/// MercuryDPM's class MindlinRollingTorsion: twice the torque limit and, at a tangential factor of 2/3, six
/// times the rolling stiffness at equal friction.
struct MercuryTurning {
  static constexpr std::string_view word = "mercury";
  static constexpr double rolling_lever = 2;
  static constexpr bool full_stiffness = true;
  static constexpr double torsion_memory = 1;
};

/// An experiment: a torsion spring that doubles in every step, as in one public snapshot of MercuryDPM. It
/// sits at its limit and pumps spin into every contact.
struct DoublingTurning {
  static constexpr std::string_view word = "doubling";
  static constexpr double rolling_lever = 1;
  static constexpr bool full_stiffness = false;
  static constexpr double torsion_memory = 2;
};

/// Coefficients of one contact, or of a vector of contacts between different species.
template <class Real>
struct ContactFriction {
  Real sliding, rolling, torsion;
};

/// Velocity at which the surfaces slide, along the contact plane. Velocities and spins are those of half a step before
/// the places. A sphere that rolls without slip does so about the normal of that time, n_h = n - v_t dt / (2 D); about
/// n it would seem to slip sideways, always the same way, by up to v^2 dt / (2 D).
///   u = v_t - l x n + dt / (2 D) (l . n) (n x v),   v_t = v - (v . n) n,   l = a_i w_i + a_j w_j
/// To first order in dt: v_t - l x n_h, projected on the plane of n.
/// \tparam midway   without it the last part of u is left out
/// \param approach  v . n [m/s]
/// \return u [m/s]
/// \source the idea: Vyas, Ottino, Lueptow & Umbanhowar, Comput. Phys. Commun. 310 (2025) 109524
template <bool midway, class Real>
Vector<Real> sliding_velocity(const ContactGeometry<Real>& g, const ContactMotion<Real>& m, const Real& approach,
                              double dt) {
  const Vector<Real> lever = g.arm_i * m.spin_i + g.arm_j * m.spin_j;
  const Vector<Real> velocity = m.velocity - approach * g.normal - cross(lever, g.normal);
  if constexpr (!midway) return velocity;
  return velocity + (Real(0.5 * dt) * g.turning * dot(lever, g.normal)) * cross(g.normal, m.velocity);
}

/// Forces and torques of one contact, and its springs one step on. The arms sum up to the distance
/// of the centres, so linear and angular momentum are conserved exactly.
/// \param law       a normal law, e.g. Hertz
/// \param friction  its coefficients: FrictionLaw, or ContactFriction
/// \param springs   of the last step; zero for a new contact; updated
/// \param rough     share of the friction that acts here: 1, or 0 where it has ended
template <class Turning, ContactTerms terms, class NormalLaw, class Coefficients, class Real>
ContactLoads<Real> contact_loads(const NormalLaw& law, const Coefficients& friction, const ContactGeometry<Real>& g,
                                 const ContactMotion<Real>& m, double dt, Springs<Real>& springs,
                                 const Real& rough = Real(1.0)) {
  const Real approach = dot(m.velocity, g.normal);
  const NormalResponse<Real> normal = law.respond(g, approach);
  ContactLoads<Real> loads{normal.force * g.normal, {}, {}};
  loads.torque_i = loads.torque_j = Vector<Real>{Real(0.0), Real(0.0), Real(0.0)};
  if constexpr (!terms.sliding && !terms.rolling && !terms.torsion) return loads;

  const Real grip = rough * normal.grip;
  const auto slider = [&](const auto& coefficient, double stiffer) {
    return SliderParameters<Real>{stiffer * normal.stiffness, normal.dashpot, coefficient * grip, dt};
  };
  const double turning = Turning::full_stiffness ? 1 / law.tangential_factor : 1;
  const Vector<Real> spin = m.spin_i - m.spin_j;
  if constexpr (terms.sliding) {
    const Vector<Real> velocity = sliding_velocity<terms.midway>(g, m, approach, dt);
    const auto [spring, force] =
        spring_slider(turn_into_plane(springs.sliding, g.normal), velocity, slider(friction.sliding, 1));
    springs.sliding = spring;
    loads.force = loads.force + force;
    const Vector<Real> turn = cross(force, g.normal);
    loads.torque_i = g.arm_i * turn;
    loads.torque_j = g.arm_j * turn;
  }
  Vector<Real> couple{Real(0.0), Real(0.0), Real(0.0)};
  if constexpr (terms.rolling) {
    const Real lever = Real(Turning::rolling_lever) * g.radius;
    const auto [spring, force] =
        spring_slider(turn_into_plane(springs.rolling, g.normal), rolling_velocity(lever, g.normal, spin),
                      slider(friction.rolling, turning));
    springs.rolling = spring;
    couple = rolling_torque(lever, g.normal, force);
  }
  if constexpr (terms.torsion) {
    const auto [spring, force] =
        spring_slider(Real(Turning::torsion_memory) * springs.torsion, torsion_velocity(g.radius, g.normal, spin),
                      slider(friction.torsion, turning));
    springs.torsion = spring;
    couple = couple + torsion_torque(g.radius, force) * g.normal;
  }
  loads.torque_i = loads.torque_i + couple;
  loads.torque_j = loads.torque_j - couple;
  return loads;
}

/// Energy stored in a contact: that of the normal law and half the stiffness of each other spring.
/// \return [J]
template <class Turning, class NormalLaw>
double stored_energy(const NormalLaw& law, const ContactGeometry<double>& g, const Springs<double>& s) {
  const double stiffness = law.respond(g, 0.0).stiffness;
  const double turned = dot(s.rolling, s.rolling) + s.torsion * s.torsion;
  const double more = Turning::full_stiffness ? 0.5 * stiffness * (1 / law.tangential_factor - 1) * turned : 0;
  return law.stored_energy(g) +
         0.5 * stiffness * (dot(s.sliding, s.sliding) + dot(s.rolling, s.rolling) + s.torsion * s.torsion) + more;
}

}  // namespace clogflow
