// What a run tells whoever watches it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace clogflow {

struct RunData;
struct RunState;

/// What a watcher is told now and then.
struct Progress {
  double time = 0, end = 0;   ///< simulated; negative while the channel is filled [s]
  std::int64_t steps = 0;     ///< done
  double particle_steps = 0;  ///< done
  std::size_t particles = 0;
  std::size_t passages = 0;
  bool clogged = false;  ///< nothing passed for half a tau
  bool filling = false;
};
Progress progress_of(const RunState& state, const RunData& recorded);
using Watcher = std::function<void(const Progress&)>;

/// Takes a line for a person; a run without anybody to tell has one that does nothing.
using Say = std::function<void(const std::string&)>;

}  // namespace clogflow
