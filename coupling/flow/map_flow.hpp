// From the samples of a solved flow case to the whole channel on a regular grid.
#pragma once

#include <filesystem>

#include "coupling/files/flow_grid.hpp"

namespace clogflow {

/// The regular grid of a solved flow case, with walls, effective scene, hash and record.
/// Velocities are those of OpenFOAM, mirrored where the channel is symmetric, and before the inlet
/// of its mesh those of developed duct flow; planes between straight walls outside the neck have
/// the flow rate of the scene restored (restore_flow_rate). Every plane is checked. Points inside a
/// wall or on it are solid with zero velocity. \throws Error when the case is not solved, is of
/// other inputs than its scene.toml, or its files do
///         not hold what they should
FlowGrid map_flow(const std::filesystem::path& folder);

}  // namespace clogflow
