// Cost against error: what a study found.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "trade/deterministic.hpp"
#include "trade/presets.hpp"
#include "trade/response.hpp"
#include "trade/study.hpp"

namespace clogflow::trade {

/// Fewer clogs than this in a sample, and no difference of it is judged.
inline constexpr double least_clogs = 10;

/// What the runs of a setting cost.
struct Cost {
  int runs = 0;
  double clogs = 0;
  double simulated = 0;        ///< filling included [s]
  double seconds = 0;          ///< of a processor, for each clog, start included [s]
  double particle_steps = 0;   ///< for each clog, likewise: what the load of a machine does not change [-]
  double step_over_limit = 0;  ///< the largest [-]
  double mean_step = 0;        ///< likewise, mean over the runs [-]
};

using Differences = std::map<std::string, Difference>;  ///< by observable
using Responses = std::map<std::string, Response>;      ///< likewise

struct SettingResult {
  Setting setting = {};
  std::string refused = {};           ///< why it was, or empty
  std::optional<Cost> cost = {};      ///< absent: it was refused or not run
  double gain = 0;                    ///< seconds of the reference over its own [-]
  Differences differences = {};       ///< from the reference
  Differences against = {};           ///< from the setting that differs in one knob; empty where that did not run
  Differences from_paper = {};        ///< by the responses, of a dose
  std::optional<double> within = {};  ///< as in Measured; absent: it is no dose, or too little ran
  bool on_front = false;              ///< nothing cheaper is as near
};

struct StudyResults {
  std::string scene = {};      ///< effective
  double diameter = 0;         ///< [m]
  double neck_ratio = 0;       ///< D/d; 0: no neck [-]
  std::string reference = {};  ///< the first setting of the matrix that has runs, or empty
  std::vector<SettingResult> settings = {};
  Responses responses = {};      ///< empty: too few settings ran
  std::string no_response = {};  ///< why, or empty
  std::vector<ShortRun> short_runs = {};
  Presets presets = {};  ///< by this study alone
};

/// Everything a study measured, and what it did not run.
StudyResults study_results(const Study& study);

/// What the program may choose from it.
MeasuredStudy measured_study(const StudyResults& results);

/// A table for a person.
std::string table(const StudyResults& results);

}  // namespace clogflow::trade
