// Drag in a random pack of equal spheres at Re -> 0: the law of the paper.
#pragma once

#include <cmath>
#include <string_view>

#include "dem/physics/drag.hpp"

namespace clogflow {

/// Neglects the inertia of the fluid and unequal sizes.
///   f(eps) = 10 (1 - eps) / eps^2 + eps^2 (1 + 1.5 sqrt(1 - eps)),  f(1) = 1
/// \source paper, text below Eq. (4); van der Hoef, Beetstra & Kuipers, J. Fluid Mech. 528 (2005) 233
struct HoefDrag {
  static constexpr std::string_view word = "hoef";
  static constexpr bool knows_slip = false, of_packs = true;

  static double factor(const Surroundings& s) {
    const double solid = 1 - s.porosity;
    const double square = s.porosity * s.porosity;
    return 10 * solid / square + square * (1 + 1.5 * std::sqrt(solid));
  }
};

}  // namespace clogflow
