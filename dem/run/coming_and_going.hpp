// Particles come in at the inlet and leave at the outlet, with the energy that they carry.
#pragma once

#include <cstdint>
#include <vector>

#include "dem/run/run_state.hpp"

namespace clogflow {

/// Lets the inlet try, if it is due.
void feed_inlet(RunState& state);

/// Marks the particles beyond the outlet, and those of an arch that is to be taken out. \throws Error if one left the
/// walls elsewhere
std::vector<std::uint8_t> leaving_particles(RunState& state);

}  // namespace clogflow
