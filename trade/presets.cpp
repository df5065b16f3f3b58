#include "trade/presets.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "coupling/base/require.hpp"
#include "dem/stability/step_limit.hpp"

namespace clogflow::trade {

namespace {

constexpr double standard_within = 0.05, fast_within = 0.10;

auto named(const StudySummary& study, const std::string& name) {
  return std::ranges::find(study.settings, name, [](const Seen& seen) { return seen.measured.name; });
}

/// A setting of the first study as all studies together see it, or nothing if one of them did not.
std::optional<Measured> everywhere(const Measured& first, const std::vector<StudySummary>& studies) {
  Measured all{.name = first.name, .overrides = first.overrides, .gain = std::numeric_limits<double>::infinity()};
  for (const StudySummary& study : studies) {
    const auto seen = named(study, first.name);
    // What is dearer than the best that this study could afford is judged by the others.
    if (seen < named(study, study.reference)) continue;
    if (seen == study.settings.end() || !seen->is_judged || seen->measured.overrides != first.overrides) return {};
    const Measured& here = seen->measured;
    if (study.reference == studies[0].reference) all.gain = std::min(all.gain, here.gain);
    all.within = std::max(all.within, here.within);
    all.step_over_limit = std::max(all.step_over_limit, here.step_over_limit);
  }
  return all.gain < std::numeric_limits<double>::infinity() ? std::optional(all) : std::nullopt;
}

/// Of those far enough from the limit of their contacts; nullptr without any.
const Measured* cheapest(const std::vector<Measured>& settings, double tolerance) {
  const Measured* best = nullptr;
  for (const Measured& setting : settings)
    if (setting.within <= tolerance && setting.step_over_limit <= near_limit && (!best || setting.gain > best->gain))
      best = &setting;
  return best;
}

}  // namespace

MeasuredSettings combine(const std::vector<StudySummary>& studies) {
  MeasuredSettings result;
  for (const StudySummary& study : studies) result.studies.push_back({study.diameter, study.reference, {}});
  for (const Seen& first : studies.at(0).settings)
    if (const auto measured = everywhere(first.measured, studies)) result.settings.push_back(*measured);
  if (result.settings.empty()) return result;
  result.presets["reference"] = result.settings[0].name;
  for (const auto& [preset, tolerance] : {std::pair{"standard", standard_within}, {"fast", fast_within}})
    if (const Measured* chosen = cheapest(result.settings, tolerance)) result.presets[preset] = chosen->name;
  return result;
}

const Measured& cheapest_within(const std::vector<Measured>& settings, double tolerance) {
  const Measured* best = cheapest(settings, tolerance);
  require(best != nullptr, "no setting was measured to be within {}", tolerance);
  return *best;
}

}  // namespace clogflow::trade
