// What a run says of itself at its end: where it came from and what it took.

#include <cmath>

#include <unistd.h>

#include "coupling/files/run_record.hpp"
#include "dem/run/simulation.hpp"

#ifndef CLOG_REVISION
#define CLOG_REVISION "unknown"
#endif

namespace clogflow {

void Simulation::finish() {
  const double seconds = state_.stopwatch.lap();
  const Inlet& inlet = state_.inlet;
  RunData& data = recorder_.data;
  char host[256] = "unknown";
  gethostname(host, sizeof host - 1);
  auto& p = data.provenance;
  data.end_time = time();
  p["program"] = "clogflow " CLOG_VERSION;
  p["revision"] = CLOG_REVISION;
  p["compiler"] = __VERSION__;
  p["instruction_set"] = kernels_.name;
  p["host"] = host;
  p[run_record::wall_time] = seconds;
  p[run_record::particle_steps] = state_.particle_steps;
  p[run_record::particle_steps_per_s] = seconds > 0 ? state_.particle_steps / seconds : 0;
  p[run_record::time_step] = state_.clock.dt();
  p["contact_time_s"] = model_.contact_time;
  const StepWatch& watch = state_.step_watch;
  if (std::isfinite(watch.smallest_limit)) p[run_record::contact_limit] = watch.smallest_limit;
  p["shaking_speed_m_s"] = watch.shaking;
  p[run_record::fill_time] = state_.filling.duration();
  p["fill_at_rest"] = state_.filling.ended_at_rest();
  p["inserted"] = inlet.inserted();
  p["insertions_refused"] = inlet.refused();
  if (inlet.shut())
    stability_.say(fmt::format("the inlet found no room for any particle in {} attempts: the channel is full up to it",
                               inlet.refused()));
  const std::int64_t left = inlet.numbered() - static_cast<std::int64_t>(state_.count());
  if (left > 0 && data.passages.time.empty())
    stability_.say(fmt::format(
        "warning: {} particle{} left at the outlet, x = {:.4g} m, and none was counted at passages.plane = {:.4g} m",
        left, left > 1 ? "s" : "", model_.domain.outlet, model_.domain.passage));
  if (model_.scene.contact.torsion_update == TorsionUpdate::doubling)
    p["experiment"] = "contact.torsion_update = \"doubling\": springs advanced wrongly on purpose";
}

}  // namespace clogflow
