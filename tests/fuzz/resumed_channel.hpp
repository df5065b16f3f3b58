// The run whose states are resumed from: a few particles that fill a channel, clog it and are released.
#pragma once

#include <optional>

#include "tests/faults/small_channel.hpp"

namespace clogflow::fuzz {

/// Every term of the model; one at a time, for the flow must outlive it.
inline std::optional<Simulation>& new_run() {
  static const Scene scene = test::small_channel(
      {"lubrication.walls=true", "time.end=4 ms", "unclog.after=1 ms", "inlet.taps=1", "porosity.strips=3"});
  static const FlowGrid flow = test::synthetic_flow(scene);
  static std::optional<Simulation> run;
  run.emplace(scene, &flow, 1);
  return run;
}

}  // namespace clogflow::fuzz
