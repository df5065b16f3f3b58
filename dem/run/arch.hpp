// The arch of a clog: the particles that bear the load at the neck.
#pragma once

#include <vector>

#include "dem/run/run_state.hpp"

namespace clogflow {

/// Particles that bear load, upstream of the passage plane and within one diameter of the one that is farthest
/// downstream. A particle bears load where at least two contacts press on it, with walls or others, by the lists as
/// they stand; one that only hangs in the flow does not.
/// Of a silo only those that reach over the orifice, with centres less than a radius beyond its rim.
/// \return their numbers, ascending; empty where none does
std::vector<int> arch_of(const RunState& state);

}  // namespace clogflow
