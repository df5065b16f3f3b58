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

/// Factor on the drag of a sphere whose diameter is y times Sauter's mean <d> of the mixture, where f(eps) of equal
/// spheres is taken at <d> and F = f factor 3 pi eta d (v - u):
///   total force        factor = eps y + (1 - eps) y^2 + 0.064 eps y^3
///   without the mean pressure gradient's share, (1 - eps) y^2 of it, over eps:  factor = y + 0.064 y^3
/// At y = 1 it is 1 + 0.064 eps, not 1: the third term is a fit to bidisperse packs, and the authors' formula for
/// equal spheres is without it. Measured for porosities up to 0.9 and diameters that differ up to fourfold; towards
/// eps = 1 a lone sphere's factor is 1, and above 0.9 we interpolate linearly to that, which is our choice.
/// Neglects that the mixture differs from place to place: <d> is that of the feed.
/// \source van der Hoef, Beetstra & Kuipers, J. Fluid Mech. 528 (2005) 233; <d> = sum N_i d_i^3 / sum N_i d_i^2;
///         which force is meant: erratum of Beetstra et al., AIChE J. 53 (2007) 489
struct UnequalSpheres {
  bool total = true;  ///< the force has the pressure gradient's share

  /// \param porosity  eps [-];  \param size  y [-]
  double factor(double porosity, double size) const {
    constexpr double most_dilute = 0.9;
    if (porosity <= most_dilute) return measured(porosity, size);
    return 1 + (measured(most_dilute, size) - 1) * (1 - porosity) / (1 - most_dilute);
  }

private:
  double measured(double eps, double y) const {
    const double fit = 0.064 * y * y * y;
    return total ? eps * (y + fit) + (1 - eps) * y * y : y + fit;
  }
};

}  // namespace clogflow
