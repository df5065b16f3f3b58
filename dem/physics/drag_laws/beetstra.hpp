// Drag in a random pack of equal spheres with the inertia of the fluid.
#pragma once

#include <cmath>
#include <string_view>

#include "dem/physics/drag_laws/hoef.hpp"

namespace clogflow {

/// Neglects unequal sizes and that particles move among each other. With phi = 1 - eps:
///   f(eps, Re) = f_hoef(eps) + 0.413 Re / (24 eps^2)
///                (1 / eps + 3 eps phi + 8.4 Re^-0.343) / (1 + 10^(3 phi) Re^(-(1 + 4 phi) / 2))
/// Fitted to lattice-Boltzmann simulations for Re up to 1000 and phi up to 0.6.
/// \source Beetstra, van der Hoef & Kuipers, AIChE J. 53 (2007) 489
struct BeetstraDrag {
  static constexpr std::string_view word = "beetstra";
  static constexpr bool knows_slip = true, of_packs = true;

  static double factor(const Surroundings& s) {
    const double at_rest = HoefDrag::factor(s);
    if (s.reynolds == 0) return at_rest;
    const double re = s.reynolds, eps = s.porosity, solid = 1 - eps;
    const double crowded = 1 / eps + 3 * eps * solid + 8.4 * std::pow(re, -0.343);
    const double slow = 1 + std::pow(10, 3 * solid) * std::pow(re, -(1 + 4 * solid) / 2);
    return at_rest + 0.413 * re / (24 * eps * eps) * crowded / slow;
  }
};

}  // namespace clogflow
