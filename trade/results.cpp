#include "trade/results.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace clogflow::trade {

namespace {

double bursts(const Sample& sample) {
  double count = 0;
  for (const Piece& piece : sample.pieces) count += piece.totals.bursts;
  return count;
}

Differences differences(const Sample& reference, const Sample& sample) {
  Differences all;
  for (const Observable& observable : observables()) all[observable.key] = compare(observable, reference, sample);
  return all;
}

/// Releases, and the stop at a clog, cut the arrests short: what is left of them says more about the protocol than the
/// clogs.
bool cut_by_protocol(const std::string& key) {
  return key == "alpha" || key == "share_censored" || key == "share_permanent";
}

/// Largest difference that is real, and the far end of the widest interval.
void judge(SettingResult& outcome, const Scene& scene) {
  const bool cuts = scene.unclog.protocol != UnclogProtocol::none;
  outcome.is_judged = true;
  for (const auto& [key, d] : outcome.differences) {
    if (!std::isfinite(d.low) || (cuts && cut_by_protocol(key))) continue;
    if (d.real()) outcome.error = std::max(outcome.error, std::abs(d.difference));
    outcome.hidden = std::max({outcome.hidden, std::abs(d.low), std::abs(d.high)});
  }
}

Cost cost_of(const Sample& sample) {
  return {.runs = sample.runs,
          .bursts = bursts(sample),
          .simulated = sample.simulated,
          .particle_steps = sample.particle_steps / sample.simulated,
          .step_over_limit = sample.step_over_limit,
          .seconds = sample.wall_seconds / sample.simulated};
}

bool competes(const SettingResult& outcome) { return outcome.is_judged && outcome.setting.kind == Kind::numerics; }

void mark_front(std::vector<SettingResult>& settings) {
  for (SettingResult& one : settings)
    one.on_front =
        competes(one) && std::ranges::none_of(settings, [&](const SettingResult& other) {
          return competes(other) && other.cost->particle_steps < one.cost->particle_steps && other.error <= one.error;
        });
}

}  // namespace

StudyResults study_results(const Study& study) {
  const Scene base = read_scene(study.scene_file, study.overrides);
  StudyResults results{.scene = effective_scene(base), .diameter = base.particles.diameter};
  std::map<std::string, Sample> samples;
  for (const Setting& setting : settings_for(base)) {
    SettingResult& outcome = results.settings.emplace_back(SettingResult{.setting = setting});
    const Sample sample = samples[setting.name] = read_sample(folder_of(study, setting));
    if (sample.runs == 0) {
      outcome.refused = refusal_of(study, setting);
      continue;
    }
    if (results.reference.empty() && setting.kind == Kind::numerics) results.reference = setting.name;
    const Sample& reference = samples[results.reference];
    outcome.cost = cost_of(sample);
    outcome.gain = reference.particle_steps / reference.simulated / outcome.cost->particle_steps;
    outcome.differences = differences(reference, sample);
    if (const auto against = samples.find(setting.against); against != samples.end() && against->second.runs)
      outcome.against = differences(against->second, sample);
    if (bursts(sample) >= least_bursts && bursts(reference) >= least_bursts) judge(outcome, base);
  }
  mark_front(results.settings);
  if (!results.reference.empty()) results.short_runs = short_runs(study);
  results.presets = combine({summary_of(results)}).presets;
  return results;
}

StudySummary summary_of(const StudyResults& results) {
  StudySummary summary{results.diameter, results.reference, {}};
  for (const SettingResult& o : results.settings)
    summary.settings.push_back({.measured = {.name = o.setting.name,
                                             .overrides = o.setting.overrides,
                                             .gain = o.gain,
                                             .error = o.error,
                                             .hidden = o.hidden,
                                             .step_over_limit = o.cost ? o.cost->step_over_limit : 0},
                                .is_numerics = o.setting.kind == Kind::numerics,
                                .is_judged = o.is_judged});
  return summary;
}

std::string table(const StudyResults& results) {
  std::string text = fmt::format("{:<26} {:>5} {:>7} {:>10} {:>7} {:>8} {:>8}  {}\n", "setting", "runs", "bursts",
                                 "cost", "gain", "error", "hidden", "");
  for (const SettingResult& o : results.settings) {
    if (!o.refused.empty()) {
      text += fmt::format("{:<26} refused: {}\n", o.setting.name, o.refused);
    } else if (!o.cost) {
      text += fmt::format("{:<26} not run\n", o.setting.name);
    } else {
      const auto number = [&](double value) { return o.is_judged ? fmt::format("{:.3f}", value) : "too few"; };
      text += fmt::format("{:<26} {:>5} {:>7} {:>10.3g} {:>7.2f} {:>8} {:>8}  {}\n", o.setting.name, o.cost->runs,
                          o.cost->bursts, o.cost->particle_steps, o.gain, number(o.error), number(o.hidden),
                          o.on_front ? "front" : "");
    }
  }
  for (const auto& [preset, name] : results.presets) text += fmt::format("{} = {}\n", preset, name);
  return text;
}

}  // namespace clogflow::trade
