// What the samples of a flow case refer to: its grid, its walls, the unit of its mesh.
#pragma once

#include <filesystem>

#include "coupling/geometry/walls.hpp"
#include "coupling/openfoam/flow_lattice.hpp"
#include "coupling/openfoam/foam_samples.hpp"
#include "coupling/scene/scene.hpp"

namespace clogflow {

struct FlowSpace {
  FlowLattice lattice;
  Walls walls;      ///< of a channel from a file; empty: the parametric channel [m]
  double unit;      ///< length that samples are given in [m]
  double copies;    ///< how many times the mesh fits into the channel
  double straight;  ///< an x where the walls are parallel to x, of a channel from a file [m]
};

FlowSpace flow_space(const Scene& scene);

/// The samples of the case in `folder`. \throws Error as read_foam_samples does
FoamSamples read_flow_samples(const std::filesystem::path& folder, const FlowSpace& space);

}  // namespace clogflow
