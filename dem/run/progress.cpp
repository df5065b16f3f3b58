#include "dem/run/progress.hpp"

#include "coupling/files/run_file.hpp"
#include "dem/run/run_state.hpp"

namespace clogflow {

Progress progress_of(const RunState& state, const RunData& recorded) {
  const bool filling = !state.filling.is_done();
  const auto& passed = recorded.passages.time;
  const double time = state.time(), half_tau = state.model.scene.stokes_time() / 2;
  return {.time = filling ? -time : time,
          .end = state.model.scene.time.end,
          .steps = state.clock.step(),
          .particle_steps = state.particle_steps,
          .particles = state.count(),
          .passages = passed.size(),
          .clogged = !filling && (passed.empty() || time - passed.back() > half_tau),
          .filling = filling};
}

}  // namespace clogflow
