#include "trade/fidelity.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "coupling/base/require.hpp"
#include "trade/knobs.hpp"
#include "trade/study_file.hpp"

namespace clogflow::trade {

// In measured_settings.cpp, which the build makes from measured.json.
extern const char* const measured_file;

const MeasuredSettings& measured_settings() {
  static const MeasuredSettings measured = parse_measured(measured_file);
  return measured;
}

namespace {

const Measured& setting_named(const std::string& name) {
  for (const Measured& setting : measured_settings().settings)
    if (setting.name == name) return setting;
  throw Error(fmt::format("measured.json names a setting {} that it does not hold", name));
}

const Measured& chosen(const Scene& scene, const std::string& file) {
  const auto& wanted = scene.fidelity;
  require(wanted.preset.empty() || wanted.tolerance == 0,
          "{}: fidelity.preset = \"{}\" and fidelity.tolerance = {} (one of them decides): leave one out", file,
          wanted.preset, wanted.tolerance);
  if (wanted.preset.empty()) return cheapest_within(measured_settings().settings, wanted.tolerance);
  const auto preset = measured_settings().presets.find(wanted.preset);
  require(preset != measured_settings().presets.end(),
          "{}: fidelity.preset = \"{}\" (must be \"reference\", \"standard\" or \"fast\")", file, wanted.preset);
  return setting_named(preset->second);
}

}  // namespace

ResolvedScene read_resolved_scene(const std::filesystem::path& file, const Overrides& overrides) {
  Scene scene = read_scene(file, overrides);
  if (scene.fidelity.preset.empty() && scene.fidelity.tolerance == 0) return {std::move(scene), ""};
  require_studied_laws(
      scene, fmt::format("{}: fidelity.{}", file.string(), scene.fidelity.preset.empty() ? "tolerance" : "preset"));
  const Measured& setting = chosen(scene, file.string());
  Overrides all = setting.overrides;
  const std::string note = fmt::format(
      "fidelity: setting {}, {:.3g} times cheaper than the reference, within {:.2g} % of it in all that was "
      "compared{}: {}",
      setting.name, setting.gain, 100 * setting.within,
      scene.drag.law == "hoef" ? "" : " (measured with drag.law = \"hoef\")", fmt::join(all, " "));
  all.insert(all.end(), overrides.begin(), overrides.end());
  scene = read_scene(file, all);
  scene.fidelity = {};
  return {std::move(scene), note};
}

}  // namespace clogflow::trade
