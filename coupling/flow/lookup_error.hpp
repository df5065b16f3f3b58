// What reading a velocity between the points of a grid costs.
#pragma once

#include "coupling/files/flow_grid.hpp"

namespace clogflow {

/// What reading between the points costs, root mean square over the points whose neighbours are all
/// fluid, and over `speed` [-]. Trilinear: the mean over a cell of s (1 - s) / 2 = 1/12 of each
/// axis' second difference; nearest: a distance of rms 1/sqrt(12) of a spacing along each axis
/// times the slope.
struct LookupError {
  double trilinear, nearest;
};
LookupError lookup_error(const FlowGrid& grid, double speed);

}  // namespace clogflow
