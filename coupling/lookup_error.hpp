// What reading a velocity from the grid costs in the neck, and the spacing for a wanted error.
#pragma once

#include "coupling/flow_grid.hpp"
#include "coupling/scene.hpp"

namespace clog {

/// Root mean square error of the velocity read from the grid at random places of a square neck's
/// developed flow, over its mean: 1.54 h / D at the nearest point, 2.4 (h / D)^1.5 trilinear, where
/// the layer beside the walls decides. Upstream the flow is slower and the error less.
/// \param spacing  h [m];  \param side  D, the shorter side of the neck [m]
/// \return [-]
/// \source measured in the series solution for D / h from 8 to 100, within 8 %
double neck_lookup_error(Lookup lookup, double spacing, double side);

/// The spacing with that error [m].
double spacing_for_error(Lookup lookup, double error, double side);

/// What reading between the points costs, root mean square over the points whose neighbours are all
/// fluid, and over `speed` [-]. Trilinear: the mean over a cell of s (1 - s) / 2 = 1/12 of each
/// axis' second difference; nearest: a distance of rms 1/sqrt(12) of a spacing along each axis
/// times the slope.
struct LookupError {
  double trilinear, nearest;
};
LookupError lookup_error(const FlowGrid& grid, double speed);

}  // namespace clog
