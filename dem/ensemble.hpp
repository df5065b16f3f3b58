// Many seeds of one scene, handed out to the ranks of an MPI job as they become free.
#pragma once

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
};

/// Told of every seed: its number, what happened.
struct SeedReport {
  std::uint64_t seed;
  std::string line;  ///< one line for a person
  bool failed;
};

/// Runs the seeds that have no run file yet. A seed that fails is reported and does not stop the rest.
/// \return number of seeds that failed, over all ranks
int run_ensemble(const Ensemble& ensemble, Ranks& ranks, const Watcher& watcher,
                 const std::function<void(const SeedReport&)>& report);

}  // namespace clog
