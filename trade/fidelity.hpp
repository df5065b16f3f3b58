// The program chooses: a wanted accuracy becomes keys of the scene, by what was measured.
#pragma once

#include <string>
#include <vector>

#include "coupling/scene/scene.hpp"
#include "trade/presets.hpp"

namespace clogflow::trade {

/// What this program was built with: trade/measured.json.
const std::vector<MeasuredStudy>& measured_studies();

struct ResolvedScene {
  Scene scene;       ///< its fidelity is empty: it has become keys
  std::string note;  ///< one line on what was chosen, or empty
};

/// Reads a scene; where it has a `fidelity`, the keys of the setting chosen replace those of the file, and
/// those of the command line replace both. The preset "reference" is the first setting of the matrix.
/// \throws Error as read_scene; if the preset is unknown, or both preset and tolerance are given, or nothing was
/// measured to be within the tolerance
ResolvedScene read_resolved_scene(const std::filesystem::path& file, const Overrides& overrides);

}  // namespace clogflow::trade
