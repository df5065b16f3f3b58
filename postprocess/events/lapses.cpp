// Passages and releases, merged in order of time.
#include "postprocess/events/lapses.hpp"

#include <algorithm>

#include "coupling/base/require.hpp"

namespace clogflow::postprocess {

const char* name(LapseEnd end) {
  switch (end) {
    case LapseEnd::passage:
      return "passage";
    case LapseEnd::release:
      return "release";
    case LapseEnd::run:
      return "run";
  }
  return "";
}

std::vector<Lapse> lapses_of(const RunData& run, const Window& window) {
  const auto& time = run.passages.time;
  require(std::is_sorted(time.begin(), time.end()), "seed {}: passages are not in order of time", run.seed);
  std::vector<Lapse> lapses;
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (run.passages.friction_off[i] || time[i] < window.start || time[i] >= window.end) continue;
    Lapse lapse{time[i], window.end - time[i], LapseEnd::run};
    if (i + 1 < time.size() && time[i + 1] <= window.end) {
      lapse.duration = time[i + 1] - time[i];
      lapse.end = LapseEnd::passage;
    }
    const auto& off = run.releases.off;
    const auto release = std::upper_bound(off.begin(), off.end(), time[i]);
    if (release != off.end() && *release - time[i] < lapse.duration) {
      lapse.duration = *release - time[i];
      lapse.end = LapseEnd::release;
    }
    lapses.push_back(lapse);
  }
  return lapses;
}

std::vector<Lapse> arrests_of(const std::vector<Lapse>& lapses, double threshold) {
  std::vector<Lapse> arrests;
  std::copy_if(lapses.begin(), lapses.end(), std::back_inserter(arrests),
               [&](const Lapse& lapse) { return lapse.duration >= threshold; });
  return arrests;
}

bool ends_clogged(const std::vector<Lapse>& lapses, const Window& window, double tau) {
  if (lapses.empty()) return window.end - window.start >= permanent_after * tau;
  return lapses.back().end == LapseEnd::run && lapses.back().duration >= permanent_after * tau;
}

Observation as_observation(const Lapse& lapse) { return {lapse.duration, lapse.end != LapseEnd::passage}; }

}  // namespace clogflow::postprocess
