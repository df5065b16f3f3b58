#include "dem/run/blow_up.hpp"

#include <cmath>

#include "coupling/base/require.hpp"
#include "dem/stability/step_limit.hpp"

namespace clogflow {

namespace {

// Not std::hypot: of (0, NaN, 0) libstdc++ 12 makes 0, and the culprit would not be named.
double speed_of(const ParticleState& p) { return std::sqrt(p.vx * p.vx + p.vy * p.vy + p.vz * p.vz); }

}  // namespace

DeepContact deepest_contact(const RunState& state) {
  const auto& p = state.particles;
  DeepContact worst;
  const auto look = [&](int i, int j, double overlap) {
    const double share = overlap / (2 * (j < 0 ? p[i].radius : std::min(p[i].radius, p[j].radius)));
    if (!(share <= worst.share)) worst = {i, j, overlap, share};
  };
  state.lists.pairs.for_each_contact([&](int i, int j, const auto&) {
    const PairPlace<double> place = pair_place(p, i, j);
    look(i, j, place.overlap(place.distance()));
  });
  if (!state.lists.walls.empty())
    for (const auto& touch : state.lists.walls.touches(p)) look(touch.particle, -1, touch.overlap);
  return worst;
}

std::string contact_words(const RunState& state, const DeepContact& contact) {
  const auto& p = state.particles;
  const ParticleState& at = p[contact.particle];
  return fmt::format("particle {} at ({:.4g}, {:.4g}, {:.4g}) m overlaps {} by {:.3g} m, {:.2g} of its diameter",
                     p.id[contact.particle], at.x, at.y, at.z,
                     contact.other < 0 ? "a wall" : fmt::format("particle {}", p.id[contact.other]), contact.overlap,
                     contact.share);
}

int fastest_particle(const RunState& state) {
  int worst = 0;
  double fastest = -1;
  for (std::size_t i = 0; i < state.count(); ++i) {
    const double speed = speed_of(state.particles[i]);
    if (speed <= fastest) continue;
    worst = static_cast<int>(i);
    fastest = speed;
    if (std::isnan(speed)) break;
  }
  return worst;
}

std::string remedy(const RunState& state, const ParticleState& worst) {
  if (!std::isfinite(speed_of(worst)) || !std::isfinite(worst.x + worst.y + worst.z))
    return "a number became infinite or none; look for two particles in one place, or lower " +
           std::string(state.model.step_key());
  // A force of the first step may be the start's or the step's: only a start that is too deep is known to be the
  // start's.
  if (state.particle_steps == 0 && deepest_contact(state).share > deepest_overlap)
    return "it begins so: move particles apart, or away from the walls";
  const Scene::Contact& contact = state.model.scene.contact;
  return fmt::format("lower {}{}{}", state.model.step_key(), adheres(contact) ? ", " : " or ", overlap_remedy(contact));
}

void blow_up(const RunState& state, const char* cause, int particle) {
  const ParticleState& worst = state.particles[particle];
  const DeepContact contact = deepest_contact(state);
  // Thrown apart, they touch no more: what they were before the step is known from its forces.
  const std::string touch = contact.overlap > 0 ? contact_words(state, contact)
                                                : fmt::format("largest overlap {:.3g} m", state.largest_overlap());
  throw Error(
      fmt::format("blow-up at step {} (t = {:.6g} s), {}: particle {} at ({:.4g}, {:.4g}, {:.4g}) m moves at "
                  "{:.3g} m/s under a force of {:.3g} N, {}; {}",
                  state.clock.step(), state.time(), cause, state.particles.id[particle], worst.x, worst.y, worst.z,
                  speed_of(worst), Vec3(worst.fx, worst.fy, worst.fz).norm(), touch, remedy(state, worst)));
}

}  // namespace clogflow
