// What a run says of itself at its end: where it came from and what it took.

#include <cmath>

#include <unistd.h>

#include <fmt/format.h>

#include "dem/run/simulation.hpp"

#ifndef CLOG_REVISION
#define CLOG_REVISION "unknown"
#endif

namespace clogflow {

void Simulation::finish() {
  state_.computing_time.lap();
  const double seconds = state_.computing_time.seconds();
  const Inlet& inlet = state_.inlet;
  RunData& data = recorder_.data;
  char host[256] = "unknown";
  gethostname(host, sizeof host - 1);
  RunRecord& r = data.record;
  data.end_time = time();
  r.program = "clogflow " CLOG_VERSION;
  r.revision = CLOG_REVISION;
  r.compiler = __VERSION__;
  r.instruction_set = kernels_.name;
  r.host = host;
  r.wall_time = seconds;
  r.processor_time = state_.computing_time.processor_seconds();
  r.particle_steps = state_.particle_steps;
  r.particle_steps_per_s = seconds > 0 ? state_.particle_steps / seconds : 0;
  r.time_step = state_.clock.dt();
  r.contact_time = model_.contact_time;
  const StepWatch& watch = state_.step_watch;
  if (std::isfinite(watch.smallest_limit)) r.contact_limit = watch.smallest_limit;
  r.shaking_speed = watch.shaking;
  r.fill_time = state_.filling.duration();
  r.fill_at_rest = state_.filling.ended_at_rest();
  const bool flowing_start = model_.scene.inlet.enabled && model_.scene.inlet.start == InletStart::flowing;
  if (flowing_start) r.start_flowed = state_.filling.flowed();
  if (model_.scene.unclog.protocol == UnclogProtocol::poke) r.poked = state_.clog_watch.taken_out();
  if (!model_.necks.empty()) {
    r.necks = static_cast<std::int64_t>(model_.necks.size());
    data.passages.neck.clear();
    for (std::size_t k = 0; k < data.passages.time.size(); ++k)
      data.passages.neck.push_back(opening_of(model_.necks, {data.passages.y[k], data.passages.z[k]}));
  }
  r.inserted = inlet.inserted();
  r.insertions_refused = inlet.refused();
  if (r.drained_at)
    stability_.say(fmt::format(
        "warning: the run ended at t = {:.4g} s: the last strip held less than half of its particles for ten Stokes "
        "times, so that what passes the neck is no dense suspension any more",
        *r.drained_at));
  if (inlet.shut())
    stability_.say(fmt::format("the inlet found no room for any particle in {} attempts: the channel is full up to it",
                               inlet.refused()));
  const std::int64_t left = inlet.numbered() - static_cast<std::int64_t>(state_.count());
  // Before a flowing start many leave, and they do not count.
  if (left > 0 && !flowing_start && data.passages.time.empty())
    stability_.say(fmt::format(
        "warning: {} particle{} left at the outlet, x = {:.4g} m, and none was counted at passages.plane = {:.4g} m",
        left, left > 1 ? "s" : "", model_.domain.outlet, model_.domain.passage));
  if (model_.scene.contact.torsion_update == TorsionUpdate::doubling)
    r.experiment = "contact.torsion_update = \"doubling\": springs advanced wrongly on purpose";
}

}  // namespace clogflow
