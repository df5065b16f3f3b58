// Survival of arrests when some outlive the run: the Kaplan-Meier estimator.
#pragma once

#include <cstddef>
#include <vector>

#include "postprocess/laws/censored.hpp"

namespace clogflow::postprocess {

/// One step of the survival function, at a time where an arrest ended.
struct SurvivalStep {
  double time = 0;          ///< [unit of the data]
  double survival = 1;      ///< P(T > time) [-]
  double error = 0;         ///< Greenwood's standard error of it [-]
  std::size_t at_risk = 0;  ///< arrests that had lasted until this time
  std::size_t ended = 0;    ///< arrests that ended at it
};

/// What ended at one time, or was cut there.
struct EndsAt {
  double time = 0;
  std::size_t ended = 0, cut = 0;
};

/// In ascending order of time.
std::vector<EndsAt> ends_of(std::vector<Observation> sample);

/// S(t) = prod_{t_i <= t} (1 - d_i/n_i), var S = S^2 sum d_i / (n_i (n_i - d_i)).
/// A value censored at the very time of an end still counts as at risk.
/// \source Kaplan & Meier 1958, J. Am. Stat. Assoc. 53:457; Greenwood 1926
std::vector<SurvivalStep> kaplan_meier(std::vector<Observation> sample);
std::vector<SurvivalStep> kaplan_meier(const std::vector<EndsAt>& ends);

}  // namespace clogflow::postprocess
