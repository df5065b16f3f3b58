#include "trade/fidelity.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "coupling/base/require.hpp"
#include "trade/knobs.hpp"
#include "trade/results.hpp"

namespace clogflow::trade {

using nlohmann::json;

// In measured_settings.cpp, which the build makes from measured.json.
extern const char* const measured_text;

const json& measured_settings() {
  static const json measured = json::parse(measured_text);
  return measured;
}

namespace {

const json& setting_named(const std::string& name) {
  for (const json& setting : measured_settings().at("settings"))
    if (setting["name"] == name) return setting;
  throw Error(fmt::format("measured.json names a setting {} that it does not hold", name));
}

const json& chosen(const Scene& scene, const std::string& file) {
  const auto& wanted = scene.fidelity;
  require(wanted.preset.empty() || wanted.tolerance == 0,
          "{}: fidelity.preset = \"{}\" and fidelity.tolerance = {} (one of them decides): leave one out", file,
          wanted.preset, wanted.tolerance);
  if (wanted.preset.empty()) return cheapest_within(measured_settings(), wanted.tolerance);
  const json& presets = measured_settings().at("presets");
  require(presets.contains(wanted.preset),
          "{}: fidelity.preset = \"{}\" (must be \"reference\", \"standard\" or \"fast\")", file, wanted.preset);
  return setting_named(presets[wanted.preset]);
}

}  // namespace

ResolvedScene read_resolved_scene(const std::filesystem::path& file, const Overrides& overrides) {
  Scene scene = read_scene(file, overrides);
  if (scene.fidelity.preset.empty() && scene.fidelity.tolerance == 0) return {std::move(scene), ""};
  require_studied_laws(
      scene, fmt::format("{}: fidelity.{}", file.string(), scene.fidelity.preset.empty() ? "tolerance" : "preset"));
  const json& setting = chosen(scene, file.string());
  Overrides all = setting["overrides"].get<Overrides>();
  const std::string note = fmt::format(
      "fidelity: setting {}, {:.3g} times cheaper than the reference; errors seen {:.2g} %, and up to {:.2g} % "
      "could hide in the intervals{}: {}",
      setting["name"].get<std::string>(), setting["gain"].get<double>(), 100 * setting["error"].get<double>(),
      100 * setting["hidden"].get<double>(), scene.drag.law == "hoef" ? "" : " (measured with drag.law = \"hoef\")",
      fmt::join(all, " "));
  all.insert(all.end(), overrides.begin(), overrides.end());
  scene = read_scene(file, all);
  scene.fidelity = {};
  return {std::move(scene), note};
}

}  // namespace clogflow::trade
