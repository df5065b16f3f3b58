#include "dem/run/coming_and_going.hpp"

#include "coupling/base/require.hpp"
#include "dem/run/arch.hpp"
#include "dem/run/blow_up.hpp"

namespace clogflow {

namespace {

double energy_of(const ParticleState& p) { return kinetic_energy(p, p.velocity(), p.spin()); }

void check_inside(const RunState& state, std::size_t i) {
  const ParticleState& p = state.particles[i];
  const Domain& d = state.model.domain;
  if (Vec3(p.x, p.y, p.z).within(d.low, d.high)) return;
  const std::string& note = state.model.walls_note;
  throw Error(fmt::format(
      "particle {} left the walls, which reach from ({:.4g}, {:.4g}, {:.4g}) to ({:.4g}, {:.4g}, {:.4g}) m, "
      "at ({:.4g}, {:.4g}, {:.4g}) m, t = {:.6g} s: {}",
      state.particles.id[i], d.low.x, d.low.y, d.low.z, d.high.x, d.high.y, d.high.z, p.x, p.y, p.z, state.time(),
      note.empty() ? remedy(state, p) : "through an opening? " + note));
}

void take_out_arch(RunState& state, std::vector<std::uint8_t>& leaving) {
  const std::vector<int> arch = arch_of(state);
  for (const int i : arch) leaving[i] = 1;
  state.clog_watch.poked(static_cast<std::int64_t>(arch.size()));
}

}  // namespace

void feed_inlet(RunState& state) {
  const double now = state.flow_time();
  if (!state.inlet.enabled() || now < state.next_insertion || state.fluid.drive().factor() <= 0) return;
  const std::size_t before = state.count();
  if (state.inlet.insert(state.particles, state.fluid, state.random, state.time()) > 0) state.lists.outdate();
  for (std::size_t i = before; i < state.count(); ++i) state.energy.brought += energy_of(state.particles[i]);
  state.next_insertion = now + state.inlet.interval();
}

std::vector<std::uint8_t> leaving_particles(RunState& state) {
  std::vector<std::uint8_t> leaving(state.count(), 0);
  if (state.clog_watch.pokes()) take_out_arch(state, leaving);
  for (std::size_t i = 0; i < state.count(); ++i) {
    if (state.particles[i].x > state.model.domain.outlet) {
      leaving[i] = 1;
    } else {
      check_inside(state, i);
    }
    if (leaving[i]) state.energy.brought -= energy_of(state.particles[i]);
  }
  return leaving;
}

}  // namespace clogflow
