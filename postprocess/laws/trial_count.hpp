// How many trials an event was waited for: whole numbers from 0 on, some of them cut.
#pragma once

#include <cstddef>
#include <vector>

#include "postprocess/laws/censored.hpp"
#include "postprocess/laws/survival.hpp"

namespace clogflow::postprocess {

/// Trials 0, 1, 2, ... until an event. With passages as trials: a particle either passes or never does, for the neck
/// clogs.
struct TrialCount {
  std::size_t passed = 0;  ///< trials without the event
  bool ended = false;      ///< the next one was the event; otherwise nobody saw how it ended
};

/// Trials whose outcome was seen.
inline std::size_t trials_of(const TrialCount& count) { return count.passed + (count.ended ? 1 : 0); }

/// For kaplan_meier, where a time is the number of a trial. Who was cut after k trials is not at risk in trial k, as
/// its outcome was not seen: half a trial less leaves it out there.
inline Observation as_observation(const TrialCount& count) {
  const auto passed = static_cast<double>(count.passed);
  return {count.ended ? passed : passed - 0.5, !count.ended};
}

std::vector<Observation> as_observations(const std::vector<TrialCount>& sample);

/// ends_of(as_observations(sample)); whole numbers are counted, which is quicker than to sort them.
std::vector<EndsAt> ends_of(const std::vector<TrialCount>& sample);

/// Sums over a sample.
struct TrialSums {
  std::size_t events = 0;
  std::size_t passed = 0;   ///< trials without the event
  std::size_t largest = 0;  ///< most trials without the event in one count
};

TrialSums sums_of(const std::vector<TrialCount>& sample);

}  // namespace clogflow::postprocess
