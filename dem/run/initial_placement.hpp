// Whether initial particles can be where their file puts them.
#pragma once

#include "dem/run/model.hpp"
#include "dem/state/initial_particles.hpp"

namespace clogflow {

/// Overlap over the smaller diameter, or over the diameter at a wall, that a run may begin with: a
/// pack as a run leaves it stays far below, and Hertz's law is off by some 10 % here.
inline constexpr double deepest_start = 0.1;

/// \throws Error with file and line for a particle outside the walls or beyond the outlet, in the
/// solid of a channel,
///         or deeper than deepest_start in a wall or another particle; and for particles where a
///         filled start puts its own
void check_placement(const InitialParticles& initial, const Model& model);

}  // namespace clogflow
