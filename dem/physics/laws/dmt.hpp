// Adhesive spheres, small and hard: Derjaguin, Muller and Toporov, with Mindlin's tangential stiffness.
#pragma once

#include <numbers>
#include <string_view>

#include "dem/physics/laws/hertz.hpp"

namespace clogflow {

/// Hertz' contact that a constant force presses while it lasts; it parts at touch. Neglects the neck that softer
/// spheres pull (law jkr) and forces before touch. An elastic impact gives back what it takes.
///   F_n = max(0, k delta - gamma sqrt(m* k) v_n) - 2 pi w R*,  k = 4/3 E* sqrt(R* delta);  k_t as Hertz'
/// Friction is limited by mu (F_n + 2 pi w R*).
/// \source Derjaguin, Muller & Toporov, J. Colloid Interface Sci. 53 (1975) 314; where it holds: Tabor,
///         J. Colloid Interface Sci. 58 (1977) 2
struct Dmt : Hertz {
  static constexpr std::string_view word = "dmt";
  static constexpr ContactTraits traits{.sticks = true};

  double surface_energy = 0;  ///< w [J/m2]

  static Dmt of(const ContactMaterials& m) { return {Hertz::of(m), m.surface_energy}; }

  /// 2 pi w R* [N]
  template <class Real>
  Real pull_off(const Real& radius) const {
    return 2 * std::numbers::pi * surface_energy * radius;
  }

  template <class Real>
  NormalResponse<Real> respond(const ContactGeometry<Real>& g, const Real& approach) const {
    NormalResponse<Real> response = Hertz::respond(g, approach);
    response.force = response.force - pull_off(g.radius);
    return response;
  }

  /// 2/5 k delta^2 - 2 pi w R* delta, below zero near touch [J]
  double stored_energy(const ContactGeometry<double>& g) const {
    return Hertz::stored_energy(g) - pull_off(g.radius) * g.overlap;
  }

  double overlap_at(double load, double radius) const { return Hertz::overlap_at(load + pull_off(radius), radius); }

  /// Of the same impact without adhesion, and what adhesion alone presses: a bound.
  double impact_overlap(double mass, double speed, double radius) const {
    return Hertz::impact_overlap(mass, speed, radius) + overlap_at(0, radius);
  }
};

}  // namespace clogflow
