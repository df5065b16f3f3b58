#include "dem/ensemble.hpp"

#include <chrono>
#include <sstream>

#include "coupling/require.hpp"
#include "coupling/run_file.hpp"
#include "dem/checkpoint.hpp"

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

/// Thrown out of a run when it is asked to stop.
struct Stopped {};

void make_directory(const std::filesystem::path& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  require(!error, "{}: cannot be made ({}): give another --out", directory.string(),
          error.message());
}

/// Saves the state of a run when it is due or when the run must stop. A state that cannot be written
/// (a full disk) is said and costs nothing but the state.
class Saver {
public:
  Saver(Simulation& simulation, Checkpoint& checkpoint, const Ensemble& ensemble,
        std::function<void(const std::string&)> say)
      : simulation_(simulation),
        checkpoint_(checkpoint),
        interval_(ensemble.scene.output.checkpoint_interval),
        stop_(ensemble.stop),
        say_(std::move(say)) {}

  void look() {
    const bool stop = stop_ && stop_->load();
    const std::chrono::duration<double> since = Clock::now() - last_;
    if (!stop && since.count() < interval_) return;
    last_ = Clock::now();
    try {
      checkpoint_.save(simulation_.save());
    } catch (const std::exception& error) {
      say_(fmt::format("the state could not be saved: {}", error.what()));
      if (stop) throw;
    }
    if (stop) throw Stopped{};
  }

private:
  using Clock = std::chrono::steady_clock;
  Simulation& simulation_;
  Checkpoint& checkpoint_;
  double interval_;
  const std::atomic<bool>* stop_;
  std::function<void(const std::string&)> say_;
  Clock::time_point last_ = Clock::now();
};

std::string summary(const RunData& run) {
  return fmt::format("{:.4g} s simulated in {:.1f} s, {:.3g} particle-steps/s, {} passages, {} releases",
                     run.end_time, run.provenance["wall_time_s"].get<double>(),
                     run.provenance["particle_steps_per_s"].get<double>(),
                     run.passages.time.size(), run.releases.off.size());
}

/// \return one line about what happened
std::string run_seed(const Ensemble& ensemble, std::uint64_t seed, const Watcher& watcher,
                     const std::function<void(const SeedReport&)>& report) {
  const Scene scene = scene_of(ensemble.scene, seed);
  const std::string scene_text = effective_scene(scene);
  const auto file = ensemble.directory / run_file_name(seed);
  if (std::filesystem::exists(file)) {
    check_same_scene(read_run_file(file), scene_text, file.string());
    return "already done";
  }
  const auto say = [&](const std::string& line) { report({seed, line, false, true}); };
  Checkpoint checkpoint(file, scene_text + (ensemble.flow ? ensemble.flow->hash : "") + CLOG_VERSION);
  Simulation simulation(scene, ensemble.flow, seed);
  if (const auto state = checkpoint.load(say)) simulation.resume(*state);
  Saver saver(simulation, checkpoint, ensemble, say);
  const RunData run = simulation.run([&](const Progress& progress) {
    saver.look();
    if (watcher) watcher(progress);
  });
  write_run_file(run, file);
  checkpoint.remove();
  return summary(run);
}

}  // namespace

EnsembleResult run_ensemble(const Ensemble& ensemble, Ranks& ranks, const Watcher& watcher,
                            const std::function<void(const SeedReport&)>& report) {
  const auto& seeds = ensemble.scene.ensemble.seeds;
  make_directory(ensemble.directory);
  EnsembleResult result;
  for (int k = ranks.next(); k < static_cast<int>(seeds.size()); k = ranks.next()) {
    const std::uint64_t seed = seeds[k];
    try {
      report({seed, run_seed(ensemble, seed, watcher, report), false});
    } catch (const Stopped&) {
      ++result.stopped;
      report({seed, "stopped; its state is saved, the same call goes on from there", false});
      break;
    } catch (const std::exception& error) {
      ++result.failed;
      report({seed, error.what(), true});
    }
  }
  return {ranks.sum(result.failed), ranks.sum(result.stopped)};
}

}  // namespace clog
