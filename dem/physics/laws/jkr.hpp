// Adhesive spheres: Johnson, Kendall and Roberts, with Mindlin's tangential stiffness.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "dem/physics/friction.hpp"
#include "dem/physics/hertz.hpp"
#include "dem/physics/jkr.hpp"
#include "dem/physics/laws/contact_materials.hpp"
#include "dem/physics/time_step.hpp"

namespace clogflow {

/// Soft elastic spheres that stick: the contact begins at touch and breaks at a gap of jkr_reach(). Neglects
/// forces before touch; what the jump into contact sets free is lost at once.
///   F_n = F_JKR(a) - gamma sqrt(m* 4/3 E* a) v_n;   k_t = factor 8 G* a
/// The dashpot is that of the same spheres without adhesion, so a rebound is slower than e says. Friction is
/// limited by mu (F_n + 2 F_c), F_c the pull-off force.
/// \source Johnson, Kendall & Roberts, Proc. R. Soc. A 324 (1971) 301; limit of friction: Thornton & Yin,
///         Powder Technol. 65 (1991) 153
struct Jkr {
  static constexpr std::string_view word = "jkr";
  static constexpr ContactTraits traits{.sticks = true};
  static constexpr bool adheres = true;

  double modulus = 0;             ///< E* [Pa]
  double shear_modulus = 0;       ///< G* [Pa]
  double tangential_factor = 0;   ///< [-]
  double gamma = 0;               ///< [-]
  double tangential_damping = 0;  ///< [-]
  double surface_energy = 0;      ///< w [J/m2] > 0

  static Jkr of(const ContactMaterials& m) {
    const double own = effective_modulus(m.own, m.other), shear = effective_shear_modulus(m.own, m.other);
    const double ratio = mindlin_stiffness(m.tangential_factor, shear, 1.0) / hertz_stiffness(own, 1.0);
    return {own,
            shear,
            m.tangential_factor,
            damping_constant(m.restitution),
            m.tangential_damping * std::sqrt(ratio),
            m.surface_energy};
  }

  template <class Real>
  Real contact_radius(const ContactGeometry<Real>& g) const {
    return jkr_contact_radius(g.overlap, g.radius, jkr_adhesion(surface_energy, modulus, g.radius));
  }

  template <class Real>
  NormalResponse<Real> respond(const ContactGeometry<Real>& g, const Real& approach) const {
    const Real a = contact_radius(g);
    const Real dashpot = dashpot_coefficient(gamma, hertz_stiffness(modulus, a), g.mass);
    const Real force = jkr_force(surface_energy, modulus, g.radius, a) - dashpot * approach;
    const Real grip = max(Real(0.0), force + 2.0 * jkr_pull_off(surface_energy, g.radius));
    return {force, grip, mindlin_stiffness(tangential_factor, shear_modulus, a), tangential_damping * dashpot};
  }

  /// The integral of the force over the overlap, 0 for parted spheres: below zero where adhesion has gained.
  ///   8 E* a^5 / (15 R*^2) - 4 sqrt(2 pi w E*) a^(7/2) / (3 R*) + pi w a^2
  double stored_energy(const ContactGeometry<double>& g) const {
    const double a = contact_radius(g), w = std::numbers::pi * surface_energy;
    return 8.0 / 15.0 * modulus * std::pow(a, 5) / (g.radius * g.radius) -
           4.0 / 3.0 * std::sqrt(2 * w * modulus) * std::pow(a, 3.5) / g.radius + w * a * a;
  }

  /// The bound 2 E* a of dF/d delta, which adhesion only lowers.
  NormalTangent tangent(const ContactGeometry<double>& g) const {
    const double a = contact_radius(g);
    return {2 * modulus * a, dashpot_coefficient(gamma, hertz_stiffness(modulus, a), g.mass)};
  }

  /// a^3 = 3 R* / (4 E*) (F + 3 pi w R* + sqrt(6 pi w R* F + (3 pi w R*)^2)), and the overlap at a.
  /// \source Johnson, Kendall & Roberts (1971); Johnson, Contact Mechanics, Eq. (5.47)
  double overlap_at(double load, double radius) const {
    const double stick = 3 * std::numbers::pi * surface_energy * radius;
    const double a = std::cbrt(0.75 * radius / modulus * (load + stick + std::sqrt(stick * (2 * load + stick))));
    return a * a / radius - std::sqrt(2 * std::numbers::pi * surface_energy * a / modulus);
  }

  /// Of the same impact without adhesion, and what adhesion alone presses.
  double impact_overlap(double mass, double speed, double radius) const {
    return std::pow(15 * mass * speed * speed / (16 * modulus * std::sqrt(radius)), 0.4) + overlap_at(0, radius);
  }

  double contact_time(const Impact& impact) const {
    return hertz_contact_time({impact.density, modulus, impact.diameter, impact.speed});
  }

  template <class Real>
  Real reach(const Real& radius) const {
    return jkr_reach(surface_energy, modulus, radius);
  }
};

}  // namespace clogflow
