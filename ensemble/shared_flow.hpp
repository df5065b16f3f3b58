// The flow of a job: read by one rank, once in the memory of each node.
#pragma once

#include "coupling/files/flow_grid.hpp"
#include "ensemble/ranks.hpp"

namespace clogflow {

/// What a run reads of a flow, on every rank: the grid, V0, walls, scene and hash. Which points are solid, and how the
/// flow came about, stay with rank 0. All ranks together.
/// \param of_first  read by rank 0 only
/// \throws Error if a node has no room for it
FlowGrid shared_flow(const FlowGrid& of_first, Ranks& ranks);

}  // namespace clogflow
