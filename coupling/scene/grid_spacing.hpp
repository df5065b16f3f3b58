// What reading a velocity from the grid costs in the neck, and the spacing for a wanted error.
#pragma once

#include "coupling/scene/scene.hpp"

namespace clogflow {

/// Root mean square error of the velocity read from the grid at random places of a square neck's
/// developed flow, over its mean: 1.54 h / D at the nearest point, 2.4 (h / D)^1.5 trilinear, where
/// the layer beside the walls decides. Upstream the flow is slower and the error less.
/// \param spacing  h [m];  \param side  D, the shorter side of the neck [m]
/// \return [-]
/// \source measured in the series solution for D / h from 8 to 100, within 8 %
double neck_lookup_error(Lookup lookup, double spacing, double side);

/// The spacing with that error [m].
double spacing_for_error(Lookup lookup, double error, double side);

}  // namespace clogflow
