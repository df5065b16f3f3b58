// Writes a complete OpenFOAM case for a scene: the template foam_case/ and the few generated files.
#pragma once

#include <filesystem>

#include "coupling/scene/scene.hpp"

namespace clogflow {

enum class FoamCaseState {
  written,   ///< new, or re-written for other inputs: its Allrun will solve
  unsolved,  ///< was there for the same inputs, refreshed, not solved yet
  solved     ///< was there for the same inputs and is solved: its Allrun has nothing to do
};

enum class FoamCaseCheck { without, with_coarser_mesh };

/// Makes `folder` the flow case of the scene. Its file `hash` holds
/// content_hash(flow_inputs(scene)), by which a flow is known, and the hash of all files that
/// OpenFOAM reads: results of other inputs or of another template are removed, those of the same
/// kept. Generated: system/sceneDict (numbers, SI), the mesh and its surfaces,
/// constant/inletProfile, scene.toml, hash. Everything else is copied from `template_folder`. With
/// a check, and where the scene extrapolates, the case of the same flow on a coarser mesh lies
/// inside, and the state is the less finished one of the two. \throws Error when the scene has no
/// OpenFOAM flow, when `folder` holds something else, or when a file
///         cannot be written
FoamCaseState write_foam_case(const Scene& scene, const std::filesystem::path& folder,
                              const std::filesystem::path& template_folder,
                              FoamCaseCheck check = FoamCaseCheck::without);

}  // namespace clogflow
