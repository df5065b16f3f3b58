// The two generated files of a flow case in OpenFOAM's syntax.
#pragma once

#include <string>

#include "coupling/openfoam/flow_lattice.hpp"
#include "coupling/openfoam/flow_mesh.hpp"
#include "coupling/scene/scene.hpp"

namespace clogflow {

/// How OpenFOAM reads its solution at the points of the grid.
struct Sampling {
  double unit = 1;  ///< length that the mesh counts in while it is sampled [m]
  const char* interpolation = "cellPointFace";
  const char* field = "U";
};

/// system/sceneDict: every number the template uses, SI units.
std::string scene_dictionary(const Scene& scene, const FlowLattice& lattice, const Sampling& sampling);

/// constant/inletProfile: the condition at the inlet, the velocity [m/s] of each face, in blockMesh's order (y
/// fastest, above the axis first).
std::string inlet_profile(const Scene& scene, const FlowMesh& mesh);

}  // namespace clogflow
