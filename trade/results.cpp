#include "trade/results.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/base/require.hpp"
#include "dem/stability/step_limit.hpp"
#include "trade/deterministic.hpp"
#include "trade/sample.hpp"

namespace clogflow::trade {

using nlohmann::json;

namespace {

constexpr double standard_tolerance = 0.05, fast_tolerance = 0.10;

/// JSON has no NaN.
json number(double value) { return std::isfinite(value) ? json(value) : json(nullptr); }

double bursts(const Sample& sample) {
  double count = 0;
  for (const Piece& piece : sample.pieces) count += piece.totals.bursts;
  return count;
}

json differences(const Sample& reference, const Sample& sample) {
  json all;
  for (const Observable& observable : observables()) {
    const Difference d = compare(observable, reference, sample);
    all[observable.key] = {{"reference", number(d.reference)},
                           {"value", number(d.value)},
                           {"difference", number(d.difference)},
                           {"low", number(d.low)},
                           {"high", number(d.high)},
                           {"real", d.real()}};
  }
  return all;
}

/// Releases, and the stop at a clog, cut the arrests short: what is left of them says more about the protocol than the
/// clogs.
bool cut_by_protocol(const std::string& key) {
  return key == "alpha" || key == "share_censored" || key == "share_permanent";
}

/// Largest difference that is real, and the far end of the widest interval.
void judge(json& entry, const Scene& scene) {
  const bool cuts = scene.unclog.protocol != UnclogProtocol::none;
  double error = 0, hidden = 0;
  for (const auto& [key, d] : entry["differences"].items()) {
    if (d["low"].is_null() || (cuts && cut_by_protocol(key))) continue;
    if (d["real"]) error = std::max(error, std::abs(d["difference"].get<double>()));
    hidden = std::max({hidden, std::abs(d["low"].get<double>()), std::abs(d["high"].get<double>())});
  }
  entry["error"] = error;
  entry["hidden"] = hidden;
}

json described(const Setting& setting) {
  return {{"name", setting.name},
          {"knob", setting.knob},
          {"against", setting.against},
          {"kind", setting.kind == Kind::numerics ? "numerics" : "physics"},
          {"overrides", setting.overrides}};
}

void add_cost(json& entry, const Sample& sample) {
  entry["runs"] = sample.runs;
  entry["bursts"] = bursts(sample);
  entry["simulated_s"] = sample.simulated;
  entry["cost"] = sample.particle_steps / sample.simulated;
  entry["step_over_limit"] = sample.step_over_limit;
  entry["seconds_per_simulated_s"] = sample.wall_seconds / sample.simulated;
}

/// On the front: nothing cheaper is as accurate.
void mark_front(json& settings) {
  for (json& one : settings) {
    if (!one.contains("error") || one["kind"] != "numerics") continue;
    one["front"] = std::none_of(settings.begin(), settings.end(), [&](const json& other) {
      return other.contains("error") && other["kind"] == "numerics" && other["cost"] < one["cost"] &&
             other["error"] <= one["error"];
    });
  }
}

json with_short_runs(const Study& study, json results) {
  results["short"] = json::array();
  for (const ShortRun& run : short_runs(study)) {
    json entry{{"name", run.name}, {"refused", run.refused}};
    if (run.refused.empty()) {
      entry["force"] = number(run.force), entry["path"] = number(run.path);
      entry["overlap"] = run.overlap, entry["particle_steps"] = run.particle_steps;
    }
    results["short"].push_back(entry);
  }
  return results;
}

}  // namespace

json study_results(const Study& study) {
  const Scene base = read_scene(study.scene_file, study.overrides);
  json results{{"format", "clogflow trade 1"},
               {"scene", effective_scene(base)},
               {"diameter", base.particles.diameter},
               {"reference", ""}};
  for (const Observable& o : observables()) results["observables"][o.key] = o.meaning;
  json& settings = results["settings"] = json::array();
  std::map<std::string, Sample> samples;
  for (const Setting& setting : settings_for(base)) {
    json entry = described(setting);
    const Sample sample = samples[setting.name] = read_sample(folder_of(study, setting));
    if (sample.runs == 0) {
      const std::string refused = refusal_of(study, setting);
      refused.empty() ? entry["not_run"] = true : entry["refused"] = refused;
    } else {
      if (results["reference"] == "" && setting.kind == Kind::numerics) results["reference"] = setting.name;
      add_cost(entry, sample);
      const Sample& reference = samples[results["reference"].get<std::string>()];
      entry["gain"] = settings.empty() ? 1.0 : 0.0;
      entry["differences"] = differences(reference, sample);
      if (const auto against = samples.find(setting.against); against != samples.end() && against->second.runs)
        entry["against_differences"] = differences(against->second, sample);
      if (bursts(sample) >= least_bursts && bursts(reference) >= least_bursts) judge(entry, base);
      entry["gain"] = reference.particle_steps / reference.simulated / entry["cost"].get<double>();
    }
    settings.push_back(entry);
  }
  mark_front(settings);
  if (results["reference"] != "") results = with_short_runs(study, std::move(results));
  results["presets"] = combine({results})["presets"];
  return results;
}

json combine(const std::vector<json>& studies) {
  json measured{{"format", "clogflow measured 1"}, {"settings", json::array()}, {"presets", json::object()}};
  for (const json& study : studies)
    measured["studies"].push_back({{"diameter", study.at("diameter")}, {"reference", study.at("reference")}});
  for (const json& first : studies.at(0).at("settings")) {
    json entry{{"name", first["name"]}, {"overrides", first.value("overrides", json::array())},
               {"gain", 1e300},         {"error", 0.0},
               {"hidden", 0.0},         {"step_over_limit", 0.0}};
    const bool everywhere = std::all_of(studies.begin(), studies.end(), [&](const json& study) {
      const auto& all = study.at("settings");
      const auto found =
          std::find_if(all.begin(), all.end(), [&](const json& s) { return s["name"] == first["name"]; });
      // What is dearer than the best that this study could afford is judged by the others.
      const auto best =
          std::find_if(all.begin(), all.end(), [&](const json& s) { return s["name"] == study.at("reference"); });
      if (found < best) return true;
      if (found == all.end() || !found->contains("error") || (*found)["kind"] != "numerics" ||
          (*found)["overrides"] != entry["overrides"])
        return false;
      if (study["reference"] == studies[0]["reference"])
        entry["gain"] = std::min(entry["gain"].get<double>(), (*found)["gain"].get<double>());
      for (const char* key : {"error", "hidden", "step_over_limit"})
        entry[key] = std::max(entry[key].get<double>(), found->value(key, 0.0));
      return true;
    });
    if (everywhere && entry["gain"] < 1e300) measured["settings"].push_back(entry);
  }
  if (measured["settings"].empty()) return measured;
  measured["presets"] = {{"reference", measured["settings"][0]["name"]},
                         {"standard", cheapest_within(measured, standard_tolerance)["name"]},
                         {"fast", cheapest_within(measured, fast_tolerance)["name"]}};
  return measured;
}

const json& cheapest_within(const json& measured, double tolerance) {
  const json* best = nullptr;
  for (const json& setting : measured.at("settings"))
    if (setting["error"].get<double>() <= tolerance && setting.value("step_over_limit", 0.0) <= near_limit &&
        (!best || setting["gain"] > (*best)["gain"]))
      best = &setting;
  require(best != nullptr, "no setting was measured to be within {}", tolerance);
  return *best;
}

std::string table(const json& results) {
  std::string text = fmt::format("{:<26} {:>5} {:>7} {:>10} {:>7} {:>8} {:>8}  {}\n", "setting", "runs", "bursts",
                                 "cost", "gain", "error", "hidden", "");
  for (const json& s : results.at("settings")) {
    const std::string name = s["name"];
    if (s.contains("refused")) {
      text += fmt::format("{:<26} refused: {}\n", name, s["refused"].get<std::string>());
    } else if (s.contains("not_run")) {
      text += fmt::format("{:<26} not run\n", name);
    } else {
      const auto number = [&](const char* key) {
        return s.contains(key) ? fmt::format("{:.3f}", s[key].get<double>()) : std::string("too few");
      };
      text += fmt::format("{:<26} {:>5} {:>7} {:>10.3g} {:>7.2f} {:>8} {:>8}  {}\n", name, s["runs"].get<int>(),
                          s["bursts"].get<double>(), s["cost"].get<double>(), s["gain"].get<double>(), number("error"),
                          number("hidden"), s.value("front", false) ? "front" : "");
    }
  }
  for (const auto& [preset, name] : results.at("presets").items())
    text += fmt::format("{} = {}\n", preset, name.get<std::string>());
  return text;
}

}  // namespace clogflow::trade
