// One seed, from its saved state or from the start, to its run file.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>

#include "coupling/files/flow_grid.hpp"
#include "coupling/files/run_file.hpp"
#include "coupling/scene/scene.hpp"
#include "dem/run/simulation.hpp"

namespace clogflow {

/// Seeds of one scene in one directory.
struct Ensemble {
  Scene scene;
  const FlowGrid* flow;
  std::filesystem::path directory;
  const std::atomic<bool>* stop = nullptr;  ///< when true: save the state and end
  std::string name = "";                    ///< what tells it from others of the same call; empty: alone
  double cost = 0;                          ///< expected, of one seed; only comparisons count
  int threads = 1;                          ///< of each run
  /// Whether a seed is still of use, asked before it begins and now and then while it runs. If given, seeds run
  /// ahead of that decision: in order, and each into ahead_file(), where it does not count until it is wanted.
  std::function<bool(std::uint64_t seed)> wanted = {};
};

/// Told of every seed: its number, what happened.
struct SeedReport {
  std::uint64_t seed;
  std::string line;  ///< one line for a person
  bool failed;
  bool note = false;       ///< something on the way; the seed goes on
  std::string point = "";  ///< name of its ensemble
};
using Reporter = std::function<void(const SeedReport&)>;

enum class SeedEnd { done, failed, stopped, left };  ///< left: no longer wanted, without a trace

/// Hash of what the scene only names: the field of the flow, the files of particles and walls.
std::string inputs_hash(const Ensemble& ensemble);

/// One seed whose lock the caller holds; done if its file is there. Whatever goes wrong is reported, not thrown.
/// \param inputs  inputs_hash of the ensemble
SeedEnd run_locked_seed(const Ensemble& ensemble, const std::string& inputs, std::uint64_t seed, const Watcher& watcher,
                        const Reporter& report);

/// What stands as done is checked and gets its place; nothing is run. \return done, failed, or left if there is more to
/// do
SeedEnd check_seed(const Ensemble& ensemble, const std::string& inputs, std::uint64_t seed, const Reporter& report);

/// One seed that nobody else is at work on, in a directory that is made; otherwise as run_locked_seed.
SeedEnd run_one_seed(const Ensemble& ensemble, std::uint64_t seed, const Watcher& watcher, const Reporter& report);

/// \throws Error
void make_directory(const std::filesystem::path& directory);

}  // namespace clogflow
