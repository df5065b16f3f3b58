// The runs of a study: every setting with every seed, until a budget is spent.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "coupling/files/flow_grid.hpp"
#include "ensemble/ranks.hpp"
#include "ensemble/seed_run.hpp"
#include "trade/knobs.hpp"
#include "trade/response.hpp"

namespace clogflow::trade {

struct Study {
  std::filesystem::path scene_file;
  Overrides overrides;  ///< of all settings
  const FlowGrid* flow = nullptr;
  std::filesystem::path directory;
  double budget = 0;  ///< of wall-clock time [s]
  const std::atomic<bool>* stop = nullptr;
  std::vector<std::string> only = {};                  ///< names of the settings to run; empty: all
  std::map<std::string, KnownSlope> step_slopes = {};  ///< by observable: the response to the step in another study
};

/// Scene of one setting. \throws Error
Scene scene_of(const Study& study, const Setting& setting);

/// Folder of the run files of one setting.
std::filesystem::path folder_of(const Study& study, const Setting& setting);

/// \throws Error if `only` names an unknown setting, or the scene is none
void check_study(const Study& study);

/// What is there was made for this scene, this flow and not for longer, so that it may be gone on with or evaluated.
/// \throws Error naming the file
void check_runs(const Study& study);

/// Runs what is missing: seed by seed, so that whenever the budget ends the settings have equal seeds.
/// Finished runs are kept, interrupted ones go on. A seed that fails leaves the reason in its folder; the next call
/// tries it once more, after all others, since the reason may have been a full disk. Rank 0 says it all. All ranks
/// together. \throws Error as check_study
void run_study(const Study& study, Ranks& ranks, const std::function<void(const std::string&)>& say);

/// Why a setting was refused, or an empty text.
std::string refusal_of(const Study& study, const Setting& setting);

}  // namespace clogflow::trade
