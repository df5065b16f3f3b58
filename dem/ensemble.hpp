// Many seeds of one or more scenes, handed out to the ranks of an MPI job as they become free.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

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
  std::string name = "";                    ///< what tells it from others of the same call; empty: alone
  double cost = 0;                          ///< expected, of one seed; only comparisons count
};

/// Told of every seed: its number, what happened.
struct SeedReport {
  std::uint64_t seed;
  std::string line;  ///< one line for a person
  bool failed;
  bool note = false;  ///< something on the way; the seed goes on
  std::string point = "";  ///< name of its ensemble
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

/// One seed of one of the ensembles.
struct Job {
  std::size_t ensemble;
  std::uint64_t seed;
};

/// All seeds of all ensembles, the dearest first, so that no rank begins a long run when the others are done.
std::vector<Job> jobs_of(const std::vector<Ensemble>& ensembles);

/// Runs the seeds that have no run file yet, each from its saved state if there is one. A seed that fails
/// is reported and does not stop the rest. States are saved every output.checkpoint_interval.
/// \return the sums over all ranks
EnsembleResult run_ensembles(const std::vector<Ensemble>& ensembles, Ranks& ranks, const Watcher& watcher,
                             const std::function<void(const SeedReport&)>& report);

}  // namespace clog
