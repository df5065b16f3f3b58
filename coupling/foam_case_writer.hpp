// Writes a complete OpenFOAM case for a scene: the template foam_case/ and the few generated files.
#pragma once

#include <filesystem>

#include "coupling/scene.hpp"

namespace clog {

enum class FoamCaseState {
  written,   ///< new, or re-written for other inputs: its Allrun will solve
  unsolved,  ///< was there for the same inputs, refreshed, not solved yet
  solved     ///< was there for the same inputs and is solved: its Allrun has nothing to do
};

/// Makes `folder` the flow case of the scene. The case is named by content_hash(flow_inputs(scene))
/// in its file `hash`; results of other inputs are removed, those of the same inputs kept.
/// Generated: system/sceneDict (numbers, SI), constant/inletProfile, scene.toml, hash. Everything
/// else is copied from `template_folder`. \throws Error when the scene has no OpenFOAM flow, when
/// `folder` holds something else, or when a file
///         cannot be written
FoamCaseState write_foam_case(const Scene& scene, const std::filesystem::path& folder,
                              const std::filesystem::path& template_folder);

}  // namespace clog
