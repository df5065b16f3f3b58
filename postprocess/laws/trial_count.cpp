#include "postprocess/laws/trial_count.hpp"

#include <algorithm>

namespace clogflow::postprocess {

std::vector<Observation> as_observations(const std::vector<TrialCount>& sample) {
  std::vector<Observation> observations;
  for (const TrialCount& count : sample) observations.push_back(as_observation(count));
  return observations;
}

std::vector<EndsAt> ends_of(const std::vector<TrialCount>& sample) {
  std::size_t largest = 0;
  for (const TrialCount& count : sample) largest = std::max(largest, count.passed);
  if (largest > sample.size() + 1000) return ends_of(as_observations(sample));
  // Two places a number: cut after so many trials, half a trial before the event after as many.
  std::vector<std::size_t> counts(2 * (largest + 1));
  for (const TrialCount& count : sample) ++counts[2 * count.passed + (count.ended ? 1 : 0)];
  std::vector<EndsAt> ends;
  for (std::size_t passed = 0; passed <= largest; ++passed) {
    const auto at = static_cast<double>(passed);
    if (const std::size_t cut = counts[2 * passed]) ends.push_back({at - 0.5, 0, cut});
    if (const std::size_t ended = counts[2 * passed + 1]) ends.push_back({at, ended, 0});
  }
  return ends;
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
