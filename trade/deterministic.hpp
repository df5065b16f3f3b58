// What can be compared particle by particle, before chaos sets in.
#pragma once

#include <string>
#include <vector>

#include "trade/study.hpp"

namespace clogflow::trade {

/// One setting from the study's packed state, radii less half the largest overlap so that nothing touches:
/// the same start for particles of any stiffness.
struct ShortRun {
  std::string name;
  std::string refused;  ///< why, or empty
  double force = 0;     ///< rms difference of the first forces (fluid and films) over their rms [-]
  double path = 0;      ///< rms difference of the ways after a tenth of tau over their rms [-]
  double overlap = 0;   ///< largest at the end, over the diameter [-]
  double particle_steps = 0;
};

/// All settings, steps down to a tenth of the scene's own at tau/50, and coarser grids, against a step of
/// tau/250. \throws Error if the study has no run to start from
std::vector<ShortRun> short_runs(const Study& study);

}  // namespace clogflow::trade
