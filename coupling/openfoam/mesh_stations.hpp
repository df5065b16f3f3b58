// Where the curves across the channel lie at which the blocks of the mesh meet.
#pragma once

#include <vector>

#include "coupling/openfoam/flow_mesh.hpp"

namespace clogflow {

/// An inlet, one station at each corner of the outline, one in the middle of the neck's first part,
/// an outlet. At a corner the curve halves the angle between the walls: the mesh is then at most
/// half the half angle away from orthogonal; with straight curves it would be the whole angle, and
/// the error at the neck's edge several times larger.
std::vector<MeshStation> mesh_stations(const Scene& scene, const ChannelShape& shape);

}  // namespace clogflow
