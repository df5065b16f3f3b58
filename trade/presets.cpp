#include "trade/presets.hpp"

#include <algorithm>
#include <utility>

#include "dem/stability/step_limit.hpp"

namespace clogflow::trade {

const Measured* cheapest_within(const std::vector<Measured>& settings, double tolerance) {
  const Measured* best = nullptr;
  for (const Measured& setting : settings)
    if (setting.within <= tolerance && setting.step_over_limit <= near_limit &&
        (!best || setting.seconds < best->seconds))
      best = &setting;
  return best;
}

Presets presets_of(const std::vector<Measured>& settings) {
  Presets presets;
  for (const auto& [preset, tolerance] : {std::pair{"standard", 0.05}, {"fast", 0.10}})
    if (const Measured* chosen = cheapest_within(settings, tolerance)) presets[preset] = chosen->name;
  return presets;
}

const MeasuredStudy& study_for(const std::vector<MeasuredStudy>& studies, const Scene& scene) {
  const double ratio = scene.geometry.neck_width / scene.particles.diameter;
  if (!(ratio > 0)) return studies.back();
  const auto found =
      std::ranges::find_if(studies, [&](const MeasuredStudy& study) { return study.neck_ratio >= 0.999 * ratio; });
  return found == studies.end() ? studies.back() : *found;
}

}  // namespace clogflow::trade
