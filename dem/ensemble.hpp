// Many seeds of one scene, handed out to the ranks of an MPI job as they become free.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>

#include "coupling/flow_grid.hpp"
#include "coupling/scene.hpp"
#include "dem/ranks.hpp"
#include "dem/initial_particles.hpp"
#include "dem/simulation.hpp"

namespace clog {

struct Ensemble {
  Scene scene;
  const FlowGrid* flow;
  std::filesystem::path directory;
  const std::atomic<bool>* stop = nullptr;  ///< when true: save the state and end
};

/// Told of every seed: its number, what happened.
struct SeedReport {
  std::uint64_t seed;
  std::string line;  ///< one line for a person
  bool failed;
  bool note = false;  ///< something on the way; the seed goes on
};

struct EnsembleResult {
  int failed = 0;   ///< seeds
  int stopped = 0;  ///< seeds that were asked to stop; their states are saved
};

enum class SeedEnd { done, failed, stopped };

/// One seed, by the rank that calls: from its saved state if there is one; done if its file is there.
/// Whatever goes wrong is reported, not thrown.
SeedEnd run_one_seed(const Ensemble& ensemble, std::uint64_t seed, const Watcher& watcher,
                     const std::function<void(const SeedReport&)>& report);

/// Runs the seeds that have no run file yet, each from its saved state if there is one. A seed that fails
/// is reported and does not stop the rest. States are saved every output.checkpoint_interval.
/// \return the sums over all ranks
EnsembleResult run_ensemble(const Ensemble& ensemble, Ranks& ranks, const Watcher& watcher,
                 const std::function<void(const SeedReport&)>& report);

}  // namespace clog
