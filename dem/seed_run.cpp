#include "dem/seed_run.hpp"

#include <chrono>
#include <optional>
#include <sstream>

#include "coupling/content_hash.hpp"
#include "coupling/require.hpp"
#include "coupling/run_file.hpp"
#include "coupling/run_record.hpp"
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

void check_same_inputs(const RunData& done, const std::string& wanted, const std::string& file) {
  require(done.provenance.value(run_record::inputs_hash, wanted) == wanted,
          "{}: was made with another flow, or other files of particles or walls: give another --out",
          file);
}

/// Thrown out of a run when it is asked to stop, or when nobody wants it any more.
struct Stopped {};
struct Left {};

/// Seconds between two questions whether a seed is still wanted: they look at files.
constexpr double ask_every = 0.5;

/// Saves the state of a run when it is due or when the run must stop. A state that cannot be written
/// (a full disk) is said and costs nothing but the state.
class Saver {
public:
  Saver(Simulation& simulation, Checkpoint& checkpoint, const Ensemble& ensemble,
        std::function<void(const std::string&)> say)
      : simulation_(simulation), checkpoint_(checkpoint), ensemble_(ensemble), say_(std::move(say)) {}

  void look() {
    const bool stop = ensemble_.stop && ensemble_.stop->load();
    if (!stop && is_left()) throw Left{};
    const std::chrono::duration<double> since = Clock::now() - last_;
    if (!stop && since.count() < ensemble_.scene.output.checkpoint_interval) return;
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

  bool is_left() {
    if (!ensemble_.wanted || std::chrono::duration<double>(Clock::now() - asked_).count() < ask_every) return false;
    asked_ = Clock::now();
    return !ensemble_.wanted(simulation_.data().seed);
  }

  Simulation& simulation_;
  Checkpoint& checkpoint_;
  const Ensemble& ensemble_;
  std::function<void(const std::string&)> say_;
  std::string problem_;  // of the last save
  Clock::time_point last_ = Clock::now(), asked_ = last_;
};

std::string summary(const RunData& run) {
  return fmt::format("{:.4g} s simulated in {:.1f} s, {:.3g} particle-steps/s, {} passages, {} releases",
                     run.end_time, run.provenance[run_record::wall_time].get<double>(),
                     run.provenance[run_record::particle_steps_per_s].get<double>(),
                     run.passages.time.size(), run.releases.off.size());
}

/// \return one line about what happened
std::string run_seed(const Ensemble& ensemble, const std::string& inputs, std::uint64_t seed,
                     const Watcher& watcher, const Reporter& report) {
  const auto file = run_file(ensemble, seed), ahead = ahead_file(ensemble, seed);
  for (const auto& there : {file, ahead}) {
    if (!std::filesystem::exists(there)) continue;
    const RunData done = read_run_file(there);
    check_same_scene(done, ensemble, seed, there);
    check_same_inputs(done, inputs, there.string());
    if (there == ahead && !ensemble.wanted) accept_ahead(ensemble, seed);
    Checkpoint(file, "").remove();  // of a run that was killed just after it wrote its file
    return "already done";
  }
  const auto say = [&](const std::string& line) { report({seed, line, false, true}); };
  const Scene scene = scene_of(ensemble.scene, seed);
  // The layout of a state is the compiled program's, and its last bits are the instruction set's.
  Checkpoint checkpoint(
      file, effective_scene(scene) + inputs + CLOG_REVISION __VERSION__ + select_kernels().name);
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
  run.provenance[run_record::inputs_hash] = inputs;
  write_run_file(run, ensemble.wanted ? ahead : file);
  checkpoint.remove();
  return summary(run);
}

}  // namespace

std::filesystem::path run_file(const Ensemble& ensemble, std::uint64_t seed) {
  return ensemble.directory / run_file_name(seed);
}

std::filesystem::path ahead_file(const Ensemble& ensemble, std::uint64_t seed) {
  std::string name = run_file_name(seed);
  return ensemble.directory / name.replace(0, name.find('_'), "ahead");
}

void accept_ahead(const Ensemble& ensemble, std::uint64_t seed) {
  std::filesystem::path ahead = ahead_file(ensemble, seed);
  if (!std::filesystem::exists(ahead)) return;
  const RunData run = read_run_file(ahead);
  check_same_scene(run, ensemble, seed, ahead);
  // Written anew, since the index of its snapshots names its file.
  write_run_file(run, run_file(ensemble, seed));
  std::filesystem::remove(ahead);
  std::filesystem::remove(ahead.replace_extension(".xmf"));
}

void remove_states(const Ensemble& ensemble, std::uint64_t seed) { Checkpoint(run_file(ensemble, seed), "").remove(); }

void check_same_scene(const RunData& done, const Ensemble& ensemble, std::uint64_t seed,
                      const std::filesystem::path& file) {
  std::istringstream a(done.scene_text), b(effective_scene(scene_of(ensemble.scene, seed)));
  for (std::string line_a, line_b; std::getline(a, line_a) && std::getline(b, line_b);)
    require(line_a == line_b,
            "{}: was made for another scene (\"{}\", now \"{}\"): give another --out", file.string(), line_a,
            line_b);
}

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

void make_directory(const std::filesystem::path& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  require(!error, "{}: cannot be made ({}): give another --out", directory.string(),
          error.message());
}

SeedEnd run_locked_seed(const Ensemble& ensemble, const std::string& inputs, std::uint64_t seed,
                        const Watcher& watcher, const Reporter& report) {
  try {
    report({seed, run_seed(ensemble, inputs, seed, watcher, report), false});
    return SeedEnd::done;
  } catch (const Stopped&) {
    report({seed, "stopped; its state is saved, the same call goes on from there", false});
    return SeedEnd::stopped;
  } catch (const Left&) {
    remove_states(ensemble, seed);
    report({seed, "not needed", false});
    return SeedEnd::left;
  } catch (const std::exception& error) {
    report({seed, error.what(), true});
    return SeedEnd::failed;
  }
}

SeedEnd run_one_seed(const Ensemble& ensemble, std::uint64_t seed, const Watcher& watcher, const Reporter& report) {
  make_directory(ensemble.directory);
  const std::string inputs = inputs_hash(ensemble);
  try {
    const auto file = run_file(ensemble, seed);
    const auto lock = SeedLock::take(file, "");
    require(lock.has_value(), "{} (another call is at work on this seed): wait for it, or give another --out",
            file.string());
    return run_locked_seed(ensemble, inputs, seed, watcher, report);
  } catch (const std::exception& error) {
    report({seed, error.what(), true});
    return SeedEnd::failed;
  }
}

}  // namespace clog
