#include "trade/study.hpp"

#include <algorithm>
#include <chrono>
#include <set>

#include "coupling/base/publish_file.hpp"
#include "coupling/base/require.hpp"
#include "coupling/base/text_file.hpp"
#include "ensemble/seed_files.hpp"

namespace clogflow::trade {

namespace fs = std::filesystem;

namespace {

fs::path refusal_file(const fs::path& folder, std::uint64_t seed) {
  return folder / fmt::format("refused_{:04d}.txt", seed);
}

void put_down(const std::string& reason, const fs::path& file) {
  fs::create_directories(file.parent_path());
  publish_file(reason + "\n", file);
}

std::vector<Setting> settings_to_run(const Study& study, const Scene& base) {
  std::vector<Setting> all = settings_for(base), chosen;
  for (const std::string& name : study.only) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Setting& s) { return s.name == name; });
    require(found != all.end(), "--settings {} (no such setting): see the table of clog trade", name);
    chosen.push_back(*found);
  }
  return study.only.empty() ? all : chosen;
}

}  // namespace

Scene scene_of(const Study& study, const Setting& setting) {
  Overrides overrides = study.overrides;
  overrides.insert(overrides.end(), setting.overrides.begin(), setting.overrides.end());
  return read_scene(study.scene_file, overrides);
}

fs::path folder_of(const Study& study, const Setting& setting) { return study.directory / "runs" / setting.name; }

std::string refusal_of(const Study& study, const Setting& setting) {
  for (const std::uint64_t seed : scene_of(study, setting).ensemble.seeds)
    if (const fs::path file = refusal_file(folder_of(study, setting), seed); fs::exists(file)) {
      std::string reason = read_text_file(file);
      return reason.substr(0, reason.find('\n'));
    }
  return "";
}

void check_study(const Study& study) { settings_to_run(study, read_scene(study.scene_file, study.overrides)); }

void check_runs(const Study& study) {
  const Scene base = read_scene(study.scene_file, study.overrides);
  require(study.flow || base.flow.source != FlowSource::openfoam,
          "{}: flow.source = \"openfoam\" needs the flow: give --flow flow.h5", study.scene_file.string());
  const std::string inputs = inputs_hash({base, study.flow, study.directory});  // of every setting
  for (const Setting& setting : settings_for(base)) {
    const Ensemble ensemble{scene_of(study, setting), study.flow, folder_of(study, setting)};
    if (!fs::exists(ensemble.directory)) continue;
    check_directory(ensemble, inputs);
    for (const std::uint64_t seed : base.ensemble.seeds) find_done(ensemble, owner_of(ensemble, inputs, seed));
  }
}

void run_study(const Study& study, Ranks& ranks, const std::function<void(const std::string&)>& say) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(study.budget);
  const Scene base = read_scene(study.scene_file, study.overrides);
  const std::vector<Setting> settings = settings_to_run(study, base);
  const auto& seeds = base.ensemble.seeds;
  std::atomic<bool> stop = false;
  const auto hear = [&] {
    for (const std::string& line : ranks.told()) say(line);
  };
  const auto look = [&](const Progress&) {
    hear();
    if (Clock::now() >= end || (study.stop && study.stop->load())) stop = true;
  };
  const std::size_t count = settings.size() * seeds.size();
  const auto refusal = [&](std::size_t k) {
    return refusal_file(folder_of(study, settings[k % settings.size()]), seeds[k / settings.size()]);
  };
  std::set<std::size_t> refused_before;
  for (std::size_t k = 0; k < count; ++k)
    if (fs::exists(refusal(k))) refused_before.insert(k);
  // First what no call has failed at, then the rest.
  for (std::size_t turn = ranks.next(); turn < 2 * count; turn = ranks.next()) {
    const std::size_t k = turn % count;
    if (refused_before.contains(k) != (turn >= count)) continue;
    const Setting& setting = settings[k % settings.size()];
    const std::uint64_t seed = seeds[k / settings.size()];
    const fs::path folder = folder_of(study, setting);
    look({});
    if (stop && !fs::exists(folder / run_file_name(seed))) continue;
    const Ensemble ensemble{scene_of(study, setting), study.flow, folder, &stop};
    const SeedEnd how = run_one_seed(ensemble, seed, look, [&](const SeedReport& report) {
      if (report.failed) put_down(report.line, refusal(k));
      if (report.note) return;
      const std::string line = fmt::format("{}, seed {}: {}", setting.name, seed, report.line);
      ranks.is_first() ? say(line) : ranks.tell_first(line);
    });
    if (how == SeedEnd::done || how == SeedEnd::stopped) fs::remove(refusal(k));
  }
  ranks.wait(hear);  // nobody reads before everybody has written
}

}  // namespace clogflow::trade
