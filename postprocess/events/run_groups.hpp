// Finds run files and groups them by scene: one group is one ensemble of seeds.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "coupling/files/run_record.hpp"
#include "coupling/scene/scene.hpp"
#include "postprocess/events/scene_lines.hpp"
#include "postprocess/events/seed_record.hpp"

namespace clogflow::postprocess {

struct RunGroup {
  Scene scene;
  std::string scene_text;  ///< effective scene of its first run
  SceneLines lines;
  ClogScale scale;
  std::vector<SeedRecord> records;  ///< in order of seed
  /// The same runs as each neck of several sees them, in order of y; empty: there is one.
  std::vector<std::vector<SeedRecord>> necks;
  RunRecord record;  ///< of its first run
};

/// run_*.h5 in a folder, or, if it has none, in the folders right below it, or the runs in a pack; in order of name.
/// \throws Error when there is none
std::vector<std::filesystem::path> find_run_files(const std::filesystem::path& folder);

/// Saved states of seeds in these folders, or one folder below, that have not ended: nothing tells of them otherwise.
std::vector<std::filesystem::path> unfinished_seeds(const std::vector<std::filesystem::path>& folders);

/// Points of a sweep ("key=value") right below a folder that hold no run file yet, in order of name.
std::vector<std::string> points_without_runs(const std::filesystem::path& folder);

/// Reads all runs. A folder holds one scene; several folders with different scenes are a sweep, and
/// runs of one scene in several folders are one group. \param threshold T_min [s]; absent: tau/2
/// \throws Error on a run file that is missing or damaged, two scenes in one folder, one seed
/// twice, or
///         a scene without a Stokes time when no threshold is given
/// \param most_readers  processes that read the files, with the same result for any number; 0: one a core
std::vector<RunGroup> gather(const std::vector<std::filesystem::path>& folders, std::optional<double> threshold,
                             std::size_t most_readers = 0);

/// Keys that vary between the groups; empty for a single one.
std::vector<std::string> swept_keys(const std::vector<RunGroup>& groups);

}  // namespace clogflow::postprocess
