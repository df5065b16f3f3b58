#include "trade/fidelity.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "coupling/base/require.hpp"
#include "trade/knobs.hpp"
#include "trade/study_file.hpp"
#include "trade/unlike.hpp"

namespace clogflow::trade {

// In measured_settings.cpp, which the build makes from measured.json.
extern const char* const measured_file;

const std::vector<MeasuredStudy>& measured_studies() {
  static const std::vector<MeasuredStudy> measured = parse_measured(measured_file);
  return measured;
}

namespace {

const Measured& setting_named(const MeasuredStudy& study, const std::string& name) {
  for (const Measured& setting : study.settings)
    if (setting.name == name) return setting;
  throw Error(fmt::format("measured.json names a setting {} that it does not hold", name));
}

const Measured& within(const MeasuredStudy& study, double tolerance, const std::string& file) {
  const Measured* best = cheapest_within(study.settings, tolerance);
  require(best != nullptr,
          "{}: fidelity.tolerance = {} (no setting was measured to be so near at D/d = {:.3g}): give a larger one, or "
          "fidelity.preset = \"reference\"",
          file, tolerance, study.neck_ratio);
  return *best;
}

/// The setting that a scene asks for, unless it is the reference, which no study had to run.
const Measured& chosen(const Scene& scene, const MeasuredStudy& study, const std::string& file) {
  const auto& wanted = scene.fidelity;
  if (wanted.preset.empty()) return within(study, wanted.tolerance, file);
  const bool is_known = wanted.preset == "standard" || wanted.preset == "fast";
  require(is_known, "{}: fidelity.preset = \"{}\" (must be \"reference\", \"standard\" or \"fast\")", file,
          wanted.preset);
  const auto preset = study.presets.find(wanted.preset);
  require(
      preset != study.presets.end(),
      "{}: fidelity.preset = \"{}\" (no setting was measured to be so near at D/d = {:.3g}): take \"reference\", or "
      "set stiffness, mass and step yourself",
      file, wanted.preset, study.neck_ratio);
  return setting_named(study, preset->second);
}

std::string note_on(const Measured& setting, const MeasuredStudy& study, const Scene& scene) {
  const double ratio = scene.geometry.neck_width / scene.particles.diameter;
  const std::string other = unlike(study.scene, scene);
  return fmt::format(
      "fidelity: setting {}, within {:.2g} % of the paper's particles by the law of the trade study at D/d = "
      "{:.3g}{}, {:.2g} core-seconds a clog there{}: {}",
      setting.name, 100 * setting.within, study.neck_ratio,
      ratio > 1.001 * study.neck_ratio ? " (nothing was measured at a larger one)" : "", setting.seconds,
      other.empty() ? "" : fmt::format(" (not measured for this scene: the study had {})", other),
      fmt::join(setting.overrides, " "));
}

}  // namespace

ResolvedScene read_resolved_scene(const std::filesystem::path& file, const Overrides& overrides) {
  Scene scene = read_scene(file, overrides);
  const auto& wanted = scene.fidelity;
  if (wanted.preset.empty() && wanted.tolerance == 0) return {std::move(scene), ""};
  require(wanted.preset.empty() || wanted.tolerance == 0,
          "{}: fidelity.preset = \"{}\" and fidelity.tolerance = {} (one of them decides): leave one out",
          file.string(), wanted.preset, wanted.tolerance);
  require_studied_laws(scene,
                       fmt::format("{}: fidelity.{}", file.string(), wanted.preset.empty() ? "tolerance" : "preset"));
  const MeasuredStudy& study = study_for(measured_studies(), scene);
  Overrides keys;
  std::string note;
  if (wanted.preset == "reference") {
    const Setting reference = settings_for(scene).front();
    keys = reference.overrides;
    note = fmt::format("fidelity: setting {}, {}: {}", reference.name, reference.knob, fmt::join(keys, " "));
  } else {
    const Measured& setting = chosen(scene, study, file.string());
    keys = setting.overrides;
    note = note_on(setting, study, scene);
  }
  keys.insert(keys.end(), overrides.begin(), overrides.end());
  scene = read_scene(file, keys);
  scene.fidelity = {};
  return {std::move(scene), note};
}

}  // namespace clogflow::trade
