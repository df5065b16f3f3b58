// A drag law as the solver holds it: a row of the registry in drag_law.cpp.
#pragma once

#include <string_view>

#include "dem/physics/drag.hpp"

namespace clogflow {

struct DragLaw {
  std::string_view word;                  ///< what a scene calls it
  bool knows_slip;                        ///< whether it asks for the Reynolds number
  bool of_packs;                          ///< whether neighbours change the drag, and so their sizes do
  double (*factor)(const Surroundings&);  ///< f, drag over that of a lone slow sphere [-]

  /// f of a pack without inertia of the fluid.
  double slow_factor(double porosity) const { return factor({porosity, 0}); }
};

/// \throws Error if there is none of that name
const DragLaw& find_drag_law(std::string_view word);

}  // namespace clogflow
