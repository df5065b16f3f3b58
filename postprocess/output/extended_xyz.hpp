// Snapshots as extended XYZ, which OVITO and ASE open: text, one frame after another.
#pragma once

#include <string>

#include "coupling/base/vector.hpp"
#include "coupling/files/run_file.hpp"

namespace clogflow::postprocess {

/// The cell that is drawn around all frames; nothing is periodic.
struct Box {
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();  ///< [m]
};

/// SI units throughout. Columns under the names by which OVITO knows them: species (particle type, from 1), pos,
/// id, radius, velo (velocity), omega (angular velocity), force, torque. Numbers have all their digits.
std::string extended_xyz(const RunData::Snapshot& snapshot, const Box& box);

}  // namespace clogflow::postprocess
