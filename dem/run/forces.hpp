// The sums of one step: loads of all contacts and films, and what the kick is made of.
#pragma once

#include "dem/run/run_state.hpp"

namespace clogflow {

/// A particle that moves farther than this share of its radius in one step was met by a contact too late.
inline constexpr double longest_way = 0.5;

/// Loads of the present places, by contacts and, unless a step takes them implicitly, films.
void sum_contacts(RunState& state, const Kernels& kernels);

/// The fluid at the particles, and the films if a step takes them implicitly; after the contacts.
void meet_fluid(RunState& state);

/// Drag, kick and drift of the next step.
AdvanceTask advance_task(RunState& state);

/// Speed at which a particle is not met by its contacts in time [m/s].
double too_fast(const RunState& state);

/// Does it, block by block; the sums are those of the blocks in order.
AdvanceTally advance_all(RunState& state, const Kernels& kernels);

}  // namespace clogflow
