#include "dem/ensemble.hpp"

#include <algorithm>
#include <chrono>
#include <functional>
#include <optional>
#include <sstream>

#include "coupling/content_hash.hpp"
#include "coupling/require.hpp"
#include "coupling/run_file.hpp"
#include "coupling/text_file.hpp"
#include "dem/checkpoint.hpp"
#include "dem/seed_lock.hpp"

namespace clog {

namespace {

/// The scene as the file of one seed carries it: its own seed alone, so that a file does not depend on
/// which other seeds were asked for.
Scene scene_of(const Scene& scene, std::uint64_t seed) {
  Scene own = scene;
  own.ensemble.seeds = {seed};
  own.ensemble.sweep.clear();
  return own;
}

/// Hash of what the scene only names: the field of the flow, the files of particles and walls.
std::string inputs_hash(const Ensemble& ensemble) {
  std::string inputs;
  if (const FlowGrid* flow = ensemble.flow) {
    inputs = flow->hash;
    inputs.append(reinterpret_cast<const char*>(flow->velocity.data()),
                  flow->velocity.size() * sizeof(float));
  }
  for (const std::string& file : {ensemble.scene.particles.initial, ensemble.scene.geometry.stl})
    if (!file.empty()) inputs += read_text_file(file);
  return content_hash(inputs);
}

void check_same_inputs(const RunData& done, const std::string& wanted, const std::string& file) {
  require(done.provenance.value("inputs_hash", wanted) == wanted,
          "{}: was made with another flow, or other files of particles or walls: give another --out",
          file);
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
      problem_.clear();
    } catch (const std::exception& error) {
      // A disk that stays full is said once.
      if (problem_ != error.what()) say_(fmt::format("the state could not be saved: {}", error.what()));
      problem_ = error.what();
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
  std::string problem_;  // of the last save
  Clock::time_point last_ = Clock::now();
};

std::string summary(const RunData& run) {
  return fmt::format("{:.4g} s simulated in {:.1f} s, {:.3g} particle-steps/s, {} passages, {} releases",
                     run.end_time, run.provenance["wall_time_s"].get<double>(),
                     run.provenance["particle_steps_per_s"].get<double>(),
                     run.passages.time.size(), run.releases.off.size());
}

/// \return one line about what happened
std::string run_seed(const Ensemble& ensemble, const std::string& inputs, std::uint64_t seed,
                     const Watcher& watcher, const std::function<void(const SeedReport&)>& report) {
  const Scene scene = scene_of(ensemble.scene, seed);
  const std::string scene_text = effective_scene(scene);
  const auto file = ensemble.directory / run_file_name(seed);
  const SeedLock lock(file);
  if (std::filesystem::exists(file)) {
    const RunData done = read_run_file(file);
    check_same_scene(done, scene_text, file.string());
    check_same_inputs(done, inputs, file.string());
    Checkpoint(file, "").remove();  // of a run that was killed just after it wrote its file
    return "already done";
  }
  const auto say = [&](const std::string& line) { report({seed, line, false, true}); };
  // The layout of a state is the compiled program's, and its last bits are the instruction set's.
  Checkpoint checkpoint(file, scene_text + inputs + CLOG_REVISION __VERSION__ + select_kernels().name);
  std::optional<Simulation> simulation(std::in_place, scene, ensemble.flow, seed);
  const auto resume = [&](const std::string& state) {
    try {
      simulation->resume(state);
    } catch (...) {
      // A state that proves bad half-way must leave nothing behind.
      simulation.emplace(scene, ensemble.flow, seed);
      throw;
    }
  };
  checkpoint.load(resume, say);
  simulation->on_note(say);
  Saver saver(*simulation, checkpoint, ensemble, say);
  RunData run = simulation->run([&](const Progress& progress) {
    saver.look();
    if (watcher) watcher(progress);
  });
  run.provenance["inputs_hash"] = inputs;
  write_run_file(run, file);
  checkpoint.remove();
  return summary(run);
}

SeedEnd run_and_report(const Ensemble& ensemble, const std::string& inputs, std::uint64_t seed,
                       const Watcher& watcher, const std::function<void(const SeedReport&)>& report) {
  try {
    report({seed, run_seed(ensemble, inputs, seed, watcher, report), false});
    return SeedEnd::done;
  } catch (const Stopped&) {
    report({seed, "stopped; its state is saved, the same call goes on from there", false});
    return SeedEnd::stopped;
  } catch (const std::exception& error) {
    report({seed, error.what(), true});
    return SeedEnd::failed;
  }
}

}  // namespace

SeedEnd run_one_seed(const Ensemble& ensemble, std::uint64_t seed, const Watcher& watcher,
                     const std::function<void(const SeedReport&)>& report) {
  make_directory(ensemble.directory);
  return run_and_report(ensemble, inputs_hash(ensemble), seed, watcher, report);
}

std::vector<Job> jobs_of(const std::vector<Ensemble>& ensembles) {
  std::vector<Job> jobs;
  for (std::size_t k = 0; k < ensembles.size(); ++k)
    for (const std::uint64_t seed : ensembles[k].scene.ensemble.seeds) jobs.push_back({k, seed});
  std::ranges::stable_sort(jobs, std::ranges::greater{},
                           [&](const Job& job) { return ensembles[job.ensemble].cost; });
  return jobs;
}

EnsembleResult run_ensembles(const std::vector<Ensemble>& ensembles, Ranks& ranks, const Watcher& watcher,
                             const std::function<void(const SeedReport&)>& report) {
  const std::vector<Job> jobs = jobs_of(ensembles);
  std::vector<std::string> inputs;
  for (const Ensemble& ensemble : ensembles) {
    make_directory(ensemble.directory);
    inputs.push_back(inputs_hash(ensemble));
  }
  EnsembleResult result;
  for (int k = ranks.next(); k < static_cast<int>(jobs.size()); k = ranks.next()) {
    const Ensemble& ensemble = ensembles[jobs[k].ensemble];
    const SeedEnd end = run_and_report(ensemble, inputs[jobs[k].ensemble], jobs[k].seed, watcher,
                                       [&](SeedReport said) {
                                         said.point = ensemble.name;
                                         report(said);
                                       });
    result.failed += end == SeedEnd::failed;
    result.stopped += end == SeedEnd::stopped;
    if (end == SeedEnd::stopped) break;
  }
  return {ranks.sum(result.failed), ranks.sum(result.stopped)};
}

}  // namespace clog
