// What clog run runs: a scene and its flow for every point of the sweep.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "coupling/files/flow_grid.hpp"
#include "coupling/scene/sweep.hpp"
#include "ensemble/ranks.hpp"

namespace clogflow::cli {

/// Where they come from.
struct RunSource {
  std::filesystem::path scene, flow;
  std::optional<std::string> seeds;
  Overrides overrides;
  std::vector<std::string> sweeps;
};

/// One point of the sweep; the only one, if there is none.
struct RunPoint {
  std::string folder;  ///< of its runs, below that of the call; empty: that of the call itself
  Scene scene;
  std::shared_ptr<const FlowGrid> flow;
  std::string note;    ///< for a person, or empty
  double cost = 0;     ///< expected, of one seed [s]
  std::string inputs;  ///< inputs_hash
};

/// Reads scene and flow, and refuses what is wrong with them for every seed. \throws Error
std::vector<RunPoint> read_run_points(const RunSource& source);

/// The points that rank 0 read, on all ranks; the flow lies once in the memory of each node. All ranks together.
std::vector<RunPoint> shared_run_points(std::vector<RunPoint> of_first, const std::filesystem::path& scene_file,
                                        Ranks& ranks);

}  // namespace clogflow::cli
