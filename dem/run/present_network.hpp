// The contacts and films of this moment, as the step's limit and the implicit films see them.
#pragma once

#include <vector>

#include "dem/fluid/films.hpp"
#include "dem/run/run_state.hpp"
#include "dem/stability/network_limit.hpp"

namespace clogflow {

/// The present contacts, films and drag, which know their largest stable step; after the forces.
NetworkLimit present_network(const RunState& state);

/// All films between particles and with walls.
std::vector<Film> present_films(const RunState& state);

}  // namespace clogflow
