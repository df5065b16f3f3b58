// A linear spring and dashpot, as most codes of granular flow offer.
#pragma once

#include <cmath>
#include <numbers>
#include <string_view>

#include "dem/physics/friction.hpp"
#include "dem/physics/hertz.hpp"
#include "dem/physics/laws/contact_materials.hpp"
#include "dem/physics/time_step.hpp"

namespace clogflow {

/// Linear contact: a stiffness that knows neither size nor load, so that one step serves all contacts. It is a
/// model of convenience: real spheres are soft when they begin to touch.
///   F_n = max(0, k delta - c v_n),  c = 2 zeta(e) sqrt(m* k);   k_t = factor k
/// \source Cundall & Strack, Geotechnique 29 (1979) 47; factor 2/7: Schaefer, Dippel & Wolf, J. Phys. I 6
///         (1996) 5
struct Hooke {
  static constexpr std::string_view word = "hooke";
  static constexpr ContactTraits traits{.knows_modulus = false};
  static constexpr bool adheres = false;

  double stiffness = 0;           ///< k [N/m]
  double tangential_factor = 0;   ///< k_t over k [-]
  double gamma = 0;               ///< 2 zeta [-]
  double tangential_damping = 0;  ///< tangential over normal dashpot coefficient [-]

  static Hooke of(const ContactMaterials& m) {
    return {m.stiffness, m.tangential_factor, 2 * damping_ratio(m.restitution),
            m.tangential_damping * std::sqrt(m.tangential_factor)};
  }

  template <class Real>
  NormalResponse<Real> respond(const ContactGeometry<Real>& g, const Real& approach) const {
    const Real dashpot = dashpot_coefficient(gamma, Real(stiffness), g.mass);
    const Real force = normal_force(stiffness * g.overlap, dashpot, approach);
    return {force, force, Real(tangential_factor * stiffness), tangential_damping * dashpot};
  }

  /// k delta^2 / 2 [J]
  double stored_energy(const ContactGeometry<double>& g) const { return 0.5 * stiffness * g.overlap * g.overlap; }

  NormalTangent tangent(const ContactGeometry<double>& g) const {
    return {stiffness, dashpot_coefficient(gamma, stiffness, g.mass)};
  }

  double overlap_at(double load, double) const { return load / stiffness; }

  /// v sqrt(m* / k) of an elastic impact [m]
  double impact_overlap(double mass, double speed, double) const { return speed * std::sqrt(mass / stiffness); }

  /// Half a period of two equal spheres, elastic: pi sqrt(m* / k), m* half a sphere's mass.
  double contact_time(const Impact& impact) const {
    const double mass = impact.density * std::numbers::pi / 6 * std::pow(impact.diameter, 3);
    return std::numbers::pi * std::sqrt(mass / 2 / stiffness);
  }

  template <class Real>
  Real reach(const Real&) const {
    return Real(0.0);
  }
};

}  // namespace clogflow
