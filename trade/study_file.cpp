#include "trade/study_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <nlohmann/json.hpp>

#include "coupling/base/json_text.hpp"
#include "coupling/base/require.hpp"
#include "coupling/base/text_file.hpp"
#include "trade/unlike.hpp"

namespace clogflow::trade {
namespace {

using nlohmann::json;

/// JSON has no NaN.
json number(double value) { return std::isfinite(value) ? json(value) : json(nullptr); }

json json_of(const Differences& differences) {
  json all;
  for (const auto& [key, d] : differences)
    all[key] = {{"reference", number(d.reference)},
                {"value", number(d.value)},
                {"difference", number(d.difference)},
                {"low", number(d.low)},
                {"high", number(d.high)},
                {"real", d.real()}};
  return all;
}

json json_of(const Responses& responses) {
  json all(json::value_t::object);
  for (const auto& [key, r] : responses) {
    json& entry = all[key] = {{"overlap_power", r.overlap_power},
                              {"chi_squared", r.chi_squared},
                              {"degrees_of_freedom", r.degrees_of_freedom},
                              {"p_value", r.p_value}};
    for (std::size_t k = 0; k < dose_names.size(); ++k)
      entry[dose_names[k]] = {{"slope", r.slope[k]}, {"error", r.error[k]}, {"low", r.low[k]}, {"high", r.high[k]}};
  }
  return all;
}

void add_runs(json& entry, const SettingResult& o) {
  entry["runs"] = o.cost->runs;
  entry["clogs"] = o.cost->clogs;
  entry["simulated_s"] = o.cost->simulated;
  entry["seconds_per_clog"] = number(o.cost->seconds);
  entry["particle_steps_per_clog"] = number(o.cost->particle_steps);
  entry["step_over_limit"] = o.cost->step_over_limit;
  entry["gain"] = number(o.gain);
  entry["differences"] = json_of(o.differences);
  if (!o.against.empty()) entry["against_differences"] = json_of(o.against);
  if (!o.within) return;
  for (const auto& [key, d] : o.from_paper)
    entry["from_paper"][key] = {{"difference", d.difference}, {"low", d.low}, {"high", d.high}};
  entry["within"] = *o.within;
  entry["front"] = o.on_front;
}

const char* word(Kind kind) { return kind == Kind::dose ? "dose" : kind == Kind::numerics ? "numerics" : "physics"; }

json json_of(const SettingResult& o) {
  json entry{{"name", o.setting.name},
             {"knob", o.setting.knob},
             {"against", o.setting.against},
             {"kind", word(o.setting.kind)},
             {"overrides", o.setting.overrides}};
  if (o.cost)
    add_runs(entry, o);
  else if (o.refused.empty())
    entry["not_run"] = true;
  else
    entry["refused"] = o.refused;
  return entry;
}

json json_of(const ShortRun& run) {
  json entry{{"name", run.name}, {"refused", run.refused}};
  if (!run.refused.empty()) return entry;
  entry["force"] = number(run.force), entry["path"] = number(run.path);
  entry["overlap"] = run.overlap, entry["particle_steps"] = run.particle_steps;
  return entry;
}

bool has_number(const json& object, const char* key) { return object.contains(key) && object[key].is_number(); }
bool has_text(const json& object, const char* key) { return object.contains(key) && object[key].is_string(); }

bool is_setting(const json& setting) {
  if (!setting.is_object() || !has_text(setting, "name")) return false;
  if (!setting.contains("within")) return true;  // it was not run, or cannot be judged
  return setting.contains("overrides") &&
         std::ranges::all_of(std::array{"seconds_per_clog", "within", "step_over_limit"},
                             [&](const char* key) { return has_number(setting, key); });
}

constexpr const char *any_format = "clogflow trade ", *format = "clogflow trade 2";

bool is_study(const json& study) {
  return study.is_object() && has_text(study, "format") && study["format"] == format &&
         has_number(study, "neck_ratio") && has_text(study, "scene") && study.contains("settings") &&
         study["settings"].is_array() && std::ranges::all_of(study["settings"], is_setting);
}

json study_in(const std::filesystem::path& file) {
  json study = parse_json(read_text_file(file));
  if (study.is_object() && has_text(study, "format")) {
    const std::string written = study["format"];
    require(
        written == format || !written.starts_with(any_format),
        "{}: \"{}\" was made by another version of the program: evaluate its runs again (clog trade --budget '0 s')",
        file.string(), written);
  }
  require(is_study(study), "{}: not a trade.json of clog trade, or damaged", file.string());
  return study;
}

Measured measured_of(const json& entry) {
  return {.name = entry["name"],
          .overrides = entry.value("overrides", Overrides{}),
          .seconds = entry["seconds_per_clog"],
          .within = entry["within"],
          .step_over_limit = entry["step_over_limit"]};
}

json json_of(const Measured& m) {
  return {{"name", m.name},
          {"overrides", m.overrides},
          {"seconds_per_clog", m.seconds},
          {"within", m.within},
          {"step_over_limit", m.step_over_limit}};
}

}  // namespace

std::string study_text(const StudyResults& results) {
  json file{{"format", format},
            {"scene", results.scene},
            {"diameter", results.diameter},
            {"neck_ratio", results.neck_ratio},
            {"reference", results.reference},
            {"settings", json::array()},
            {"presets", json(json::value_t::object)}};
  for (const Observable& o : observables()) file["observables"][o.key] = o.meaning;
  file["responses"] = json_of(results.responses);
  if (!results.no_response.empty()) file["no_response"] = results.no_response;
  for (const SettingResult& outcome : results.settings) file["settings"].push_back(json_of(outcome));
  if (!results.reference.empty()) file["short"] = json::array();
  for (const ShortRun& run : results.short_runs) file["short"].push_back(json_of(run));
  for (const auto& [preset, name] : results.presets) file["presets"][preset] = name;
  return file.dump(1) + "\n";
}

MeasuredStudy read_study(const std::filesystem::path& file) {
  const json read = study_in(file);
  MeasuredStudy study{.neck_ratio = read["neck_ratio"], .scene = read["scene"]};
  for (const json& entry : read["settings"])
    if (entry.contains("within")) study.settings.push_back(measured_of(entry));
  study.presets = presets_of(study.settings);
  return study;
}

std::map<std::string, KnownSlope> read_step_slopes(const std::filesystem::path& file, const Scene& scene) {
  const json study = study_in(file);
  const std::string other = unlike(study["scene"], scene, "particles.size_");  // a step acts on contacts
  require(other.empty(),
          "--step-from {}: is of another scene ({}): give a study that differs in the sizes of particles alone",
          file.string(), other);
  std::map<std::string, KnownSlope> slopes;
  const json responses = study.value("responses", json::object());
  for (const auto& [key, response] : responses.items()) {
    const json step = response.is_object() ? response.value("step", json::object()) : json::object();
    require(step.is_object() && has_number(step, "slope") && has_number(step, "error") && step["error"] > 0,
            "{}: not a trade.json of clog trade, or damaged", file.string());
    slopes[key] = {step["slope"], step["error"]};
  }
  require(!slopes.empty(), "{}: this study found no response to the step (too few settings ran)", file.string());
  return slopes;
}

std::string measured_text(std::vector<MeasuredStudy> studies) {
  std::ranges::sort(studies, {}, &MeasuredStudy::neck_ratio);
  json file{{"format", "clogflow measured 3"}, {"studies", json::array()}};
  for (const MeasuredStudy& study : studies) {
    json settings = json::array();
    for (const Measured& m : study.settings) settings.push_back(json_of(m));
    file["studies"].push_back(
        {{"neck_ratio", study.neck_ratio}, {"scene", study.scene}, {"settings", settings}, {"presets", study.presets}});
  }
  return file.dump(1) + "\n";
}

std::vector<MeasuredStudy> parse_measured(const std::string& text) {
  std::vector<MeasuredStudy> studies;
  const json file = json::parse(text);
  for (const json& entry : file.at("studies")) {
    MeasuredStudy study{.neck_ratio = entry.at("neck_ratio"),
                        .scene = entry.at("scene"),
                        .presets = entry.at("presets").get<Presets>()};
    for (const json& setting : entry.at("settings")) study.settings.push_back(measured_of(setting));
    studies.push_back(study);
  }
  return studies;
}

}  // namespace clogflow::trade
