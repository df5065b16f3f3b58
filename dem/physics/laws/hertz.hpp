// Hertz' contact with a dashpot and Mindlin's tangential stiffness: the law of the paper.
#pragma once

#include <cmath>
#include <string_view>

#include "dem/physics/friction.hpp"
#include "dem/physics/hertz.hpp"
#include "dem/physics/laws/contact_materials.hpp"
#include "dem/physics/time_step.hpp"

namespace clogflow {

/// Elastic spheres that touch in a small circle; neglects adhesion, plasticity and the slip annulus.
///   F_n = max(0, k delta - gamma sqrt(m* k) v_n),  k = 4/3 E* sqrt(R* delta)
///   k_t = factor 8 G* sqrt(R* delta)
/// \source paper Eq. (1); Di Renzo & Di Maio, Chem. Eng. Sci. 60 (2005) 1303; dashpot_coefficient()
struct Hertz {
  static constexpr std::string_view word = "hertz";
  static constexpr ContactTraits traits{};
  static constexpr bool adheres = false;

  double modulus = 0;             ///< E* [Pa]
  double shear_modulus = 0;       ///< G* [Pa]
  double tangential_factor = 0;   ///< [-]
  double gamma = 0;               ///< normal damping constant [-]
  double tangential_damping = 0;  ///< tangential over normal dashpot coefficient [-]

  static Hertz of(const ContactMaterials& m) {
    Hertz law{effective_modulus(m.own, m.other), effective_shear_modulus(m.own, m.other), m.tangential_factor,
              damping_constant(m.restitution), 0};
    // Both dashpots are gamma sqrt(m* k) with their own stiffness, times the scene's ratio.
    law.tangential_damping =
        m.tangential_damping *
        std::sqrt(mindlin_stiffness(law.tangential_factor, law.shear_modulus, 1.0) / hertz_stiffness(law.modulus, 1.0));
    return law;
  }

  template <class Real>
  NormalResponse<Real> respond(const ContactGeometry<Real>& g, const Real& approach) const {
    const Real root = sqrt(g.radius * g.overlap);
    const Real secant = hertz_stiffness(modulus, root);
    const Real dashpot = dashpot_coefficient(gamma, secant, g.mass);
    const Real force = normal_force(secant * g.overlap, dashpot, approach);
    return {force, force, mindlin_stiffness(tangential_factor, shear_modulus, root), tangential_damping * dashpot};
  }

  /// 2/5 k delta^2 [J]
  double stored_energy(const ContactGeometry<double>& g) const {
    return 0.4 * hertz_stiffness(modulus, std::sqrt(g.radius * g.overlap)) * g.overlap * g.overlap;
  }

  /// dF/d delta = 3/2 k [N/m], and the dashpot [N s/m].
  NormalTangent tangent(const ContactGeometry<double>& g) const {
    const double secant = hertz_stiffness(modulus, std::sqrt(g.radius * g.overlap));
    return {1.5 * secant, dashpot_coefficient(gamma, secant, g.mass)};
  }

  /// \source inverse of paper Eq. (1)
  double overlap_at(double load, double radius) const { return hertz_overlap(load, modulus, radius); }

  /// Largest overlap of an elastic impact: (15 m* v^2 / (16 E* sqrt(R*)))^(2/5).
  /// \source K. L. Johnson, Contact Mechanics, Eq. (11.21)
  double impact_overlap(double mass, double speed, double radius) const {
    return std::pow(15 * mass * speed * speed / (16 * modulus * std::sqrt(radius)), 0.4);
  }

  double contact_time(const Impact& impact) const {
    return hertz_contact_time({impact.density, modulus, impact.diameter, impact.speed});
  }

  template <class Real>
  Real reach(const Real&) const {
    return Real(0.0);
  }
};

}  // namespace clogflow
