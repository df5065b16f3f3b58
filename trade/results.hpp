// Cost against error: what a study found.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "trade/deterministic.hpp"
#include "trade/presets.hpp"
#include "trade/sample.hpp"
#include "trade/study.hpp"

namespace clogflow::trade {

/// Fewer whole bursts than this in a sample, and no difference of it is judged.
inline constexpr double least_bursts = 10;

/// What the runs of a setting cost. Particle-steps are the cost, which the load of the machine does not change;
/// seconds stand beside it.
struct Cost {
  int runs = 0;
  double bursts = 0;
  double simulated = 0;        ///< filling included [s]
  double particle_steps = 0;   ///< per simulated second [1/s]
  double step_over_limit = 0;  ///< [-]
  double seconds = 0;          ///< of the clock, per simulated second [-]
};

using Differences = std::map<std::string, Difference>;  ///< by observable

struct SettingResult {
  Setting setting = {};
  std::string refused = {};       ///< why it was, or empty
  std::optional<Cost> cost = {};  ///< absent: it was refused or not run
  double gain = 0;                ///< cost of the reference over its own [-]
  Differences differences = {};   ///< from the reference
  Differences against = {};       ///< from the setting that differs in one knob; empty where that did not run
  bool is_judged = false;         ///< both have enough bursts
  double error = 0, hidden = 0;   ///< as in Measured
  bool on_front = false;          ///< nothing cheaper is as accurate
};

struct StudyResults {
  std::string scene = {};      ///< effective
  double diameter = 0;         ///< [m]
  std::string reference = {};  ///< the first setting of the matrix that has runs, or empty
  std::vector<SettingResult> settings = {};
  std::vector<ShortRun> short_runs = {};
  Presets presets = {};  ///< by this study alone
};

/// Everything a study measured, and what it did not run.
StudyResults study_results(const Study& study);

/// What counts of it beside other studies.
StudySummary summary_of(const StudyResults& results);

/// A table for a person.
std::string table(const StudyResults& results);

}  // namespace clogflow::trade
