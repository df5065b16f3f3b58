// The block mesh and the surfaces between its blocks in OpenFOAM's syntax.
#pragma once

#include <string>
#include <vector>

#include "coupling/openfoam/flow_mesh.hpp"

namespace clogflow {

/// How a dictionary that we write begins.
std::string dictionary_header(const char* object);

/// system/blockMeshDict: half of the channel's height, and of its width where it is symmetric.
/// \param half_height  [m]
std::string block_mesh_dictionary(const FlowMesh& mesh, double half_height);

/// system/topoSetDict: the surfaces between the blocks as face zones that point downstream; there
/// the mass flux is known exactly.
std::string surfaces_dictionary(const FlowMesh& mesh);

/// Names of inlet, surfaces between blocks and outlet, downstream.
std::vector<std::string> station_names(const FlowMesh& mesh);

/// system/fluxDict: the function objects that write the volume flux through inlet, surfaces,
/// outlet.
std::string flux_dictionary(const std::vector<std::string>& names);

/// surfaces: the names, one a line.
std::string surface_names(const std::vector<std::string>& names);

}  // namespace clogflow
