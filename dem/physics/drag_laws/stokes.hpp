// Drag of a lone sphere, whatever is around it.
#pragma once

#include <string_view>

#include "dem/physics/drag.hpp"

namespace clogflow {

/// f = 1: neglects that neighbours hinder the flow.
/// \source Stokes (1851)
struct StokesDrag {
  static constexpr std::string_view word = "stokes";
  static constexpr bool knows_slip = false, of_packs = false;

  static double factor(const Surroundings&) { return 1; }
};

}  // namespace clogflow
