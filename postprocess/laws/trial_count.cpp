#include "postprocess/laws/trial_count.hpp"

#include <algorithm>

namespace clogflow::postprocess {

std::vector<Observation> as_observations(const std::vector<TrialCount>& sample) {
  std::vector<Observation> observations;
  for (const TrialCount& count : sample) observations.push_back(as_observation(count));
  return observations;
}

TrialSums sums_of(const std::vector<TrialCount>& sample) {
  TrialSums sums;
  for (const TrialCount& count : sample) {
    sums.events += count.ended ? 1 : 0;
    sums.passed += count.passed;
    sums.largest = std::max(sums.largest, count.passed);
  }
  return sums;
}

}  // namespace clogflow::postprocess
