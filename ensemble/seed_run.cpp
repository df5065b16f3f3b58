#include "ensemble/seed_run.hpp"

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>

#include "coupling/base/content_hash.hpp"
#include "coupling/base/require.hpp"
#include "coupling/base/text_file.hpp"
#include "coupling/files/run_file.hpp"
#include "dem/run/checkpoint.hpp"
#include "ensemble/seed_files.hpp"
#include "ensemble/seed_lock.hpp"

namespace clogflow {

namespace {

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

/// What ended the run before its time, in words.
const char* early_end(const RunRecord& record) {
  if (record.drained_at) return ", then the neck was drained";
  if (!record.clogged_at) return "";
  return record.clog_proved.value_or(false) ? ", then a clog at rest for good" : ", then a clog that did not break";
}

std::string summary(const RunData& run) {
  const auto& off = run.passages.friction_off;
  const auto without_friction = std::count(off.begin(), off.end(), 1);
  return fmt::format("{:.4g} s simulated in {:.1f} s, {:.3g} particle-steps/s, {} passages{}, {} releases{}",
                     run.end_time, *run.record.wall_time, *run.record.particle_steps_per_s, off.size(),
                     without_friction > 0 ? fmt::format(" ({} of them without friction)", without_friction) : "",
                     run.releases.off.size(), early_end(run.record));
}

/// Where a simulation stands, in words.
std::string standing(const Simulation& simulation) {
  if (simulation.data().series.time.empty()) return "in the filling of the channel";
  return fmt::format("at t = {:.6g} s", simulation.time());
}

/// The run as its saved state has it, else as the shorter run left it, else at its beginning.
std::unique_ptr<Simulation> begin(const Ensemble& ensemble, Checkpoint& checkpoint, std::uint64_t seed,
                                  const std::function<void(const std::string&)>& say) {
  const Scene scene = scene_of(ensemble.scene, seed);
  auto simulation = std::make_unique<Simulation>(scene, ensemble.flow, seed, ensemble.threads);
  std::filesystem::path from = checkpoint.load(
      [&](const std::string& state) {
        // A state that proves bad half-way must leave nothing behind.
        auto resumed = std::make_unique<Simulation>(scene, ensemble.flow, seed, ensemble.threads);
        resumed->resume(state);
        simulation = std::move(resumed);
      },
      say);
  if (const auto shorter = shorter_file(ensemble, seed); from.empty() && std::filesystem::exists(shorter)) {
    simulation->lengthen(read_run_file(shorter), unpack_state(read_end_state(shorter)).state);
    from = shorter;
  }
  if (!from.empty()) say(fmt::format("goes on from {} {}", from.string(), standing(*simulation)));
  return simulation;
}

/// What is there under whichever name gets its place. \return one line, if there is no more to do
std::optional<std::string> finished_before(const Ensemble& ensemble, const StateOwner& owner, Checkpoint& checkpoint) {
  const auto done = find_done(ensemble, owner);
  if (!done) return {};
  const bool is_aside = done->file == shorter_file(ensemble, owner.seed);
  if (done->shorter) {
    if (!is_aside) set_aside(ensemble, owner, *done);
    return {};
  }
  read_run_file(done->file);  // says what is wrong with it
  require(!is_aside || !checkpoint.is_there(),
          "{} is what is asked for, but run {} is saved on its way to a later time.end: let that finish, or give "
          "another --out",
          done->file.string(), owner.seed);
  give_place(ensemble, owner.seed, done->file);
  // Of a run that was killed just after it wrote its file.
  checkpoint.remove();
  std::error_code ignored;
  std::filesystem::remove(shorter_file(ensemble, owner.seed), ignored);
  return done->note.empty() ? "already done" : fmt::format("already done, with {}", done->note);
}

/// \return one line about what happened
std::string run_seed(const Ensemble& ensemble, const std::string& inputs, std::uint64_t seed, const Watcher& watcher,
                     const Reporter& report) {
  const StateOwner owner = owner_of(ensemble, inputs, seed);
  Checkpoint checkpoint(run_file(ensemble, seed), owner);
  if (const auto line = finished_before(ensemble, owner, checkpoint)) return *line;
  const auto say = [&](const std::string& line) { report({seed, line, false, true}); };
  const auto simulation = begin(ensemble, checkpoint, seed, say);
  simulation->on_note(say);
  simulation->hurry_when(ensemble.stop);
  Saver saver(*simulation, checkpoint, ensemble, say);
  RunData run = simulation->run([&](const Progress& progress) {
    saver.look();
    if (watcher) watcher(progress);
  });
  run.record.inputs_hash = inputs;
  run.end_state = pack_state({owner, std::move(run.end_state)});
  write_run_file(run, ensemble.wanted ? ahead_file(ensemble, seed) : run_file(ensemble, seed));
  checkpoint.remove();
  std::error_code ignored;
  std::filesystem::remove(shorter_file(ensemble, seed), ignored);
  return summary(run);
}

}  // namespace

std::string inputs_hash(const Ensemble& ensemble) {
  std::string inputs;
  if (const FlowGrid* flow = ensemble.flow) {
    inputs = flow->hash;
    const std::span<const float> field = flow->field();
    inputs.append(reinterpret_cast<const char*>(field.data()), field.size_bytes());
  }
  for (const std::string& file :
       {ensemble.scene.particles.initial, ensemble.scene.geometry.stl, ensemble.scene.flow.oscillation.table})
    if (!file.empty()) inputs += read_text_file(file);
  return content_hash(inputs);
}

void make_directory(const std::filesystem::path& directory) {
  std::error_code error;
  // A name that ends with a slash is none of a file.
  const std::filesystem::path name = directory.has_filename() ? directory : directory.parent_path();
  require(!std::filesystem::is_regular_file(name, error),
          "{}: is a file: runs go into a folder, and none is added to a pack (clog pack): give another --out",
          name.string());
  std::filesystem::create_directories(directory, error);
  require(!error, "{}: cannot be made ({}): give another --out", directory.string(), error.message());
}

SeedEnd run_locked_seed(const Ensemble& ensemble, const std::string& inputs, std::uint64_t seed, const Watcher& watcher,
                        const Reporter& report) {
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

SeedEnd check_seed(const Ensemble& ensemble, const std::string& inputs, std::uint64_t seed, const Reporter& report) {
  try {
    const StateOwner owner = owner_of(ensemble, inputs, seed);
    Checkpoint checkpoint(run_file(ensemble, seed), owner);
    const auto line = finished_before(ensemble, owner, checkpoint);
    report({seed, line.value_or("is lengthened by another call: left to that"), false, !line});
    return line ? SeedEnd::done : SeedEnd::left;
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
    if (!lock) {
      report({seed, "another call is at work on it: left to that", false, true});
      return SeedEnd::left;
    }
    return run_locked_seed(ensemble, inputs, seed, watcher, report);
  } catch (const std::exception& error) {
    report({seed, error.what(), true});
    return SeedEnd::failed;
  }
}

}  // namespace clogflow
