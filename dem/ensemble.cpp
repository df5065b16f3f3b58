#include "dem/ensemble.hpp"

#include <sstream>

#include "coupling/require.hpp"
#include "coupling/run_file.hpp"

namespace clog {

namespace {

/// The scene as the file of one seed carries it: its own seed alone, so that a file does not depend on
/// which other seeds were asked for.
Scene scene_of(const Scene& scene, std::uint64_t seed) {
  Scene own = scene;
  own.ensemble.seeds = {seed};
  return own;
}

void check_same_scene(const RunData& done, const std::string& wanted, const std::string& file) {
  std::istringstream a(done.scene_text), b(wanted);
  for (std::string line_a, line_b; std::getline(a, line_a) && std::getline(b, line_b);)
    require(line_a == line_b,
            "{}: was made for another scene (\"{}\", now \"{}\"): give another --out", file, line_a,
            line_b);
}

std::string summary(const RunData& run) {
  return fmt::format("{:.4g} s simulated in {:.1f} s, {:.3g} particle-steps/s, {} passages, {} releases",
                     run.end_time, run.provenance["wall_time_s"].get<double>(),
                     run.provenance["particle_steps_per_s"].get<double>(),
                     run.passages.time.size(), run.releases.off.size());
}

}  // namespace

int run_ensemble(const Ensemble& ensemble, Ranks& ranks, const Watcher& watcher,
                 const std::function<void(const SeedReport&)>& report) {
  const auto& seeds = ensemble.scene.ensemble.seeds;
  std::filesystem::create_directories(ensemble.directory);
  int failed = 0;
  for (int k = ranks.next(); k < static_cast<int>(seeds.size()); k = ranks.next()) {
    const std::uint64_t seed = seeds[k];
    const auto file = ensemble.directory / run_file_name(seed);
    const Scene scene = scene_of(ensemble.scene, seed);
    try {
      if (std::filesystem::exists(file)) {
        check_same_scene(read_run_file(file), effective_scene(scene), file.string());
        report({seed, "already done", false});
        continue;
      }
      Simulation simulation(scene, ensemble.flow, seed);
      const RunData run = simulation.run(watcher);
      write_run_file(run, file);
      report({seed, summary(run), false});
    } catch (const std::exception& error) {
      ++failed;
      report({seed, error.what(), true});
    }
  }
  return ranks.sum(failed);
}

}  // namespace clog
