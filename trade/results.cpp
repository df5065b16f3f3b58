#include "trade/results.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "coupling/base/require.hpp"

namespace clogflow::trade {

namespace {

using Samples = std::map<std::string, Sample>;

/// What a study of this scene compares.
std::vector<Observable> compared(const Scene& scene) {
  std::vector<Observable> all = observables();
  if (scene.unclog.protocol != UnclogProtocol::none)
    std::erase_if(all, [](const Observable& o) { return o.needs_whole_arrests; });
  return all;
}

Differences differences(const Scene& scene, const Sample& reference, const Sample& sample) {
  Differences all;
  for (const Observable& observable : compared(scene)) all[observable.key] = compare(observable, reference, sample);
  return all;
}

Cost cost_of(const Sample& sample) {
  return {.runs = sample.runs,
          .clogs = sample.clogs(),
          .simulated = sample.simulated,
          .seconds = sample.processor_seconds / sample.clogs(),
          .particle_steps = sample.particle_steps / sample.clogs(),
          .step_over_limit = sample.largest_step,
          .mean_step = sample.mean_step};
}

Doses doses_in(const Study& study, const SettingResult& one) {
  return doses_of(scene_of(study, one.setting), one.cost->mean_step);
}

/// Whether the law is fitted to it and speaks of it.
bool is_dose(const Study& study, const SettingResult& one) {
  return one.setting.kind == Kind::dose && one.cost && one.cost->clogs >= least_clogs && is_small(doses_in(study, one));
}

/// One response an observable, through all doses that ran, and what each of these is by it.
void add_responses(StudyResults& results, const Study& study, const Scene& base, const Samples& samples) {
  const double usual = usual_burst(samples.at(results.reference));
  for (const Observable& observable : compared(base)) {
    std::vector<Answer> answers;
    for (const SettingResult& one : results.settings)
      if (is_dose(study, one))
        answers.push_back({doses_in(study, one), spread_of(observable, samples.at(one.setting.name), usual)});
    const auto step = study.step_slopes.find(observable.key);
    results.responses[observable.key] = fit_response(
        answers, observable.is_share, step == study.step_slopes.end() ? std::nullopt : std::optional(step->second),
        observable.overlap_power);
  }
  for (SettingResult& one : results.settings) {
    if (!is_dose(study, one)) continue;
    one.within = 0;
    for (const Observable& observable : compared(base)) {
      const Difference d = results.responses.at(observable.key).from_paper(doses_in(study, one), observable.is_share);
      one.from_paper[observable.key] = d;
      one.within = std::max(*one.within, d.within());
    }
  }
}

void mark_front(std::vector<SettingResult>& settings) {
  for (SettingResult& one : settings)
    one.on_front = one.within && std::ranges::none_of(settings, [&](const SettingResult& other) {
                     return other.within && other.cost->seconds < one.cost->seconds && *other.within <= *one.within;
                   });
}

}  // namespace

StudyResults study_results(const Study& study) {
  const Scene base = read_scene(study.scene_file, study.overrides);
  StudyResults results{.scene = effective_scene(base),
                       .diameter = base.particles.diameter,
                       .neck_ratio = base.geometry.neck_width / base.particles.diameter};
  Samples samples;
  for (const Setting& setting : settings_for(base)) {
    SettingResult& outcome = results.settings.emplace_back(SettingResult{.setting = setting});
    const Sample sample = samples[setting.name] = read_sample(folder_of(study, setting));
    if (sample.runs == 0) {
      outcome.refused = refusal_of(study, setting);
      continue;
    }
    if (results.reference.empty() && setting.kind == Kind::dose) results.reference = setting.name;
    outcome.cost = cost_of(sample);
    if (results.reference.empty()) continue;
    const Sample& reference = samples[results.reference];
    outcome.gain = cost_of(reference).seconds / outcome.cost->seconds;
    outcome.differences = differences(base, reference, sample);
  }
  for (SettingResult& outcome : results.settings)
    if (const auto against = samples.find(outcome.setting.against);
        outcome.cost && against != samples.end() && against->second.runs)
      outcome.against = differences(base, against->second, samples.at(outcome.setting.name));
  if (!results.reference.empty()) {
    try {
      add_responses(results, study, base, samples);
    } catch (const Error& error) {
      results.responses.clear();
      results.no_response = error.what();
    }
    results.short_runs = short_runs(study);
  }
  mark_front(results.settings);
  results.presets = measured_study(results).presets;
  return results;
}

MeasuredStudy measured_study(const StudyResults& results) {
  MeasuredStudy study{.neck_ratio = results.neck_ratio, .scene = results.scene};
  for (const SettingResult& o : results.settings)
    if (o.within)
      study.settings.push_back({.name = o.setting.name,
                                .overrides = o.setting.overrides,
                                .seconds = o.cost->seconds,
                                .within = *o.within,
                                .step_over_limit = o.cost->step_over_limit});
  study.presets = presets_of(study.settings);
  return study;
}

std::string table(const StudyResults& results) {
  std::string text = fmt::format("{:<26} {:>5} {:>7} {:>10} {:>7} {:>8}  {}\n", "setting", "runs", "clogs", "s a clog",
                                 "gain", "within", "");
  for (const SettingResult& o : results.settings) {
    if (!o.refused.empty()) {
      text += fmt::format("{:<26} refused: {}\n", o.setting.name, o.refused);
    } else if (!o.cost) {
      text += fmt::format("{:<26} not run\n", o.setting.name);
    } else {
      const auto number = [](double value) { return std::isfinite(value) ? fmt::format("{:.3g}", value) : "-"; };
      text += fmt::format("{:<26} {:>5} {:>7} {:>10} {:>7} {:>8}  {}\n", o.setting.name, o.cost->runs, o.cost->clogs,
                          number(o.cost->seconds), number(o.gain), o.within ? fmt::format("{:.3f}", *o.within) : "-",
                          o.on_front ? "front" : "");
    }
  }
  if (!results.no_response.empty()) text += "no response: " + results.no_response + "\n";
  for (const auto& [preset, name] : results.presets) text += fmt::format("{} = {}\n", preset, name);
  return text;
}

}  // namespace clogflow::trade
