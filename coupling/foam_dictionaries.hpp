// The two generated files of a flow case in OpenFOAM's syntax.
#pragma once

#include <string>

#include "coupling/flow_lattice.hpp"
#include "coupling/flow_mesh.hpp"
#include "coupling/scene.hpp"

namespace clog {

/// system/sceneDict: every number the template uses, SI units.
std::string scene_dictionary(const Scene& scene, const FlowLattice& lattice);

/// constant/inletProfile: the velocity [m/s] of each inlet face, in blockMesh's order (y
/// fastest, above the axis first).
std::string inlet_profile(const Scene& scene, const FlowMesh& mesh);

}  // namespace clog
