#include "ensemble/seed_files.hpp"

#include <algorithm>

#include "coupling/base/require.hpp"
#include "coupling/base/text_file.hpp"
#include "coupling/base/units.hpp"
#include "coupling/scene/scene_difference.hpp"
#include "dem/kernels/kernels.hpp"

namespace clogflow {

namespace {

namespace fs = std::filesystem;

fs::path renamed(const Ensemble& ensemble, std::uint64_t seed, const char* prefix) {
  std::string name = run_file_name(seed);
  return ensemble.directory / name.replace(0, name.find('_'), prefix);
}

bool is_there(const fs::path& file) {
  std::error_code ignored;
  return fs::exists(file, ignored);
}

void remove_with_index(fs::path run) {
  std::error_code ignored;
  fs::remove(run, ignored);
  fs::remove(run.replace_extension(".xmf"), ignored);
}

using Differences = std::vector<SceneDifference>;

void check_trajectory(const fs::path& file, const Differences& differences) {
  if (const auto other = find_role(differences, KeyRole::trajectory))
    throw Error(fmt::format("{}: was made for another scene ({}): give another --out", file.string(), other->words()));
}

void check_inputs(const fs::path& file, const RunData& done, const std::string& inputs) {
  require(done.record.inputs_hash.value_or(inputs) == inputs,
          "{}: was made with another flow, or other files of particles or walls: give another --out", file.string());
}

/// Whether a run ends before another one would. \throws Error if it ends after it
bool is_shorter(const fs::path& file, const Differences& differences, double wanted_end) {
  const auto length = find_role(differences, KeyRole::length);
  if (!length) return false;
  require(length->before.size() > 2, "{}: its scene has no time.end: give another --out", file.string());
  const double end = parse_quantity(std::string_view(length->before).substr(1, length->before.size() - 2)).si;
  require(end < wanted_end, "{}: is longer than what is asked for ({}): give another --out", file.string(),
          length->words());
  return true;
}

/// The scene that a result or a saved state was made for, and the flow; nothing for other files and
/// damaged ones.
std::optional<StateOwner> owner_in(const fs::path& file) {
  const std::string name = file.filename().string();
  try {
    if (name.starts_with("run_") && name.ends_with(".state")) return unpack_state(read_text_file(file)).owner;
    if (!name.ends_with(".h5")) return {};
    for (const char* prefix : {"run_", "ahead_", "shorter_"})
      if (name.starts_with(prefix)) {
        const RunData head = read_run_head(file);
        return StateOwner{.scene_text = head.scene_text,
                          .inputs = head.record.inputs_hash.value_or(""),
                          .build = "",
                          .instruction_set = "",
                          .seed = head.seed};
      }
  } catch (const std::exception&) {
    // Its own seed says what is wrong with it.
  }
  return {};
}

}  // namespace

fs::path run_file(const Ensemble& ensemble, std::uint64_t seed) { return ensemble.directory / run_file_name(seed); }

fs::path ahead_file(const Ensemble& ensemble, std::uint64_t seed) { return renamed(ensemble, seed, "ahead"); }

fs::path shorter_file(const Ensemble& ensemble, std::uint64_t seed) { return renamed(ensemble, seed, "shorter"); }

Scene scene_of(const Scene& scene, std::uint64_t seed) {
  Scene own = scene;
  own.ensemble.seeds = {seed};
  own.ensemble.sweep.clear();
  return own;
}

StateOwner owner_of(const Ensemble& ensemble, const std::string& inputs, std::uint64_t seed) {
  return {.scene_text = effective_scene(scene_of(ensemble.scene, seed)),
          .inputs = inputs,
          .build = CLOG_REVISION ", compiler " __VERSION__,
          .instruction_set = select_kernels().name,
          .seed = seed};
}

std::optional<Done> find_done(const Ensemble& ensemble, const StateOwner& owner) {
  for (const fs::path& file :
       {run_file(ensemble, owner.seed), ahead_file(ensemble, owner.seed), shorter_file(ensemble, owner.seed)}) {
    if (!is_there(file)) continue;
    const RunData head = read_run_head(file);
    require(head.seed == owner.seed, "{}: is of seed {}: give another --out", file.string(), head.seed);
    const Differences differences = scene_differences(head.scene_text, owner.scene_text);
    check_trajectory(file, differences);
    check_inputs(file, head, owner.inputs);
    const bool shorter = is_shorter(file, differences, ensemble.scene.time.end);
    const auto records = find_role(differences, KeyRole::records);
    return Done{file, shorter, records ? records->words() : ""};
  }
  return {};
}

void set_aside(const Ensemble& ensemble, const StateOwner& owner, const Done& shorter) {
  const std::string state = read_end_state(shorter.file);
  require(!state.empty(),
          "{}: ends before time.end = {} s and holds no state to go on from (an earlier program "
          "made it): give another --out",
          shorter.file.string(), ensemble.scene.time.end);
  try {
    check_may_go_on(unpack_state(state).owner, owner);
  } catch (const Error& error) {
    throw Error(fmt::format("{}: ends before time.end = {} s and cannot go on: its state {}", shorter.file.string(),
                            ensemble.scene.time.end, error.what()));
  }
  std::error_code failure;
  fs::rename(shorter.file, shorter_file(ensemble, owner.seed), failure);
  require(!failure, "{}: cannot be renamed to be lengthened ({})", shorter.file.string(), failure.message());
  remove_with_index(shorter.file);
}

void give_place(const Ensemble& ensemble, std::uint64_t seed, const fs::path& done) {
  const fs::path place = ensemble.wanted ? ahead_file(ensemble, seed) : run_file(ensemble, seed);
  if (done == place || done == run_file(ensemble, seed)) return;
  RunData run = read_run_file(done);
  check_same_scene(run, ensemble, seed, done);
  run.end_state = read_end_state(done);
  // Written anew, since the index of its snapshots names its file.
  write_run_file(run, place);
  remove_with_index(done);
}

void accept_ahead(const Ensemble& ensemble, std::uint64_t seed) {
  if (!is_there(ahead_file(ensemble, seed))) return;
  Ensemble decided = ensemble;
  decided.wanted = {};
  give_place(decided, seed, ahead_file(ensemble, seed));
}

void remove_states(const Ensemble& ensemble, std::uint64_t seed) { Checkpoint(run_file(ensemble, seed), {}).remove(); }

void check_same_scene(const RunData& done, const Ensemble& ensemble, std::uint64_t seed, const fs::path& file) {
  for (const SceneDifference& each :
       scene_differences(done.scene_text, effective_scene(scene_of(ensemble.scene, seed))))
    require(role_of(each.key) != KeyRole::trajectory && role_of(each.key) != KeyRole::length,
            "{}: was made for another scene ({}): give another --out", file.string(), each.words());
}

std::string check_directory(const Ensemble& ensemble, const std::string& inputs) {
  std::error_code none_yet;
  for (const auto& entry : fs::directory_iterator(ensemble.directory, none_yet)) {
    const auto there = owner_in(entry.path());
    if (!there) continue;
    const Differences differences =
        scene_differences(there->scene_text, effective_scene(scene_of(ensemble.scene, there->seed)));
    check_trajectory(entry.path(), differences);
    require(there->inputs.empty() || there->inputs == inputs,
            "{}: was made with another flow, or other files of particles or walls: give another --out",
            entry.path().string());
    const auto length = find_role(differences, KeyRole::length);
    const bool asked_for = std::ranges::count(ensemble.scene.ensemble.seeds, there->seed) > 0;
    if (!length || asked_for) return {};
    return fmt::format(
        "{}: has another length ({}); clog stats takes only runs of one length from a folder: ask "
        "for all its seeds",
        entry.path().string(), length->words());
  }
  return {};
}

}  // namespace clogflow
