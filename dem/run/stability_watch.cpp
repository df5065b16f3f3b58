#include "dem/run/stability_watch.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "coupling/base/quantile.hpp"
#include "coupling/base/require.hpp"
#include "dem/physics/contact_laws.hpp"
#include "dem/run/blow_up.hpp"
#include "dem/run/present_network.hpp"
#include "dem/run/whole_step.hpp"
#include "dem/stability/step_limit.hpp"
#include "dem/state/initial_particles.hpp"

namespace clogflow {

namespace {

struct Speeds {
  std::vector<double> between, at;  ///< whole steps [m/s]
};

/// Of the particles near the neck, turning included.
Speeds speeds_near_neck(const RunState& state) {
  const auto& p = state.particles;
  const auto speed = [](const Vec3& v, const Vec3& w, double radius) {
    return std::max(std::sqrt(dot(v, v)), radius * std::sqrt(dot(w, w)));
  };
  Speeds speeds;
  for (const int i : near_neck(p, state.model.scene)) {
    speeds.between.push_back(speed(p[i].velocity(), p[i].spin(), p[i].radius));
    speeds.at.push_back(speed(velocity_now(state, i), spin_now(state, i), p[i].radius));
  }
  return speeds;
}

/// The limit of the present contacts, where it may matter: it may be near, or the contacts became stiffer.
struct Limit {
  double step;   ///< [s]
  int particle;  ///< that limits it
};
std::optional<Limit> present_limit(const RunState& state, StepWatch& watch) {
  const NetworkLimit network = present_network(state);
  const NetworkLimit::Bound bound = network.bound();
  const bool near = state.clock.dt() > near_limit * bound.step;
  const bool stiffer = bound.step < (1 - NetworkLimit::resolution) * watch.smallest_bound;
  if (!stiffer && !(near && state.clock.step() % look_at_whole_every == 0)) return {};
  if (stiffer) watch.smallest_bound = bound.step;
  // The bound is safe; whether a step near it is, the whole network says.
  const double limit = near ? network.exact(bound) : bound.step;
  watch.smallest_limit = std::min(watch.smallest_limit, limit);
  return Limit{limit, bound.particle};
}

}  // namespace

std::string StabilityWatch::announce(const Model& model) const {
  const InitialParticles initial = read_initial_file(model.scene);
  const StepLimits limits = expected_limits(model, initial.particles);
  const std::string words = limit_words(limits, model.dt);
  say(words);
  say(initial.note);
  say(model.walls_note);
  say(check_step(limits, model));
  say(passing_warning(limits, model.dt));
  say(impact_warning(limits, model.dt));
  return words;
}

void StabilityWatch::look(RunState& state) const {
  if (state.clock.step() % look_every != 0 || state.count() == 0) return;
  look_at_limit(state);
  look_for_shaking(state);
  const double stored = kinetic_energy(state) + elastic_energy(state);
  if (state.step_watch.appeared(stored, state.energy.supplied()))
    blow_up(state, "energy from nothing", fastest_particle(state));
}

void StabilityWatch::look_at_limit(RunState& state) const {
  const auto limit = present_limit(state, state.step_watch);
  const double dt = state.clock.dt();
  if (!limit || dt <= near_limit * limit->step) return;
  const auto& p = state.particles;
  const int i = limit->particle;
  const std::string what = fmt::format(
      "the step of {:.3g} s is {} the limit of the contacts of particle {} at ({:.4g}, {:.4g}, {:.4g}) m, "
      "{:.3g} s",
      dt, dt > limit->step ? "above" : "near", p.id[i], p[i].x, p[i].y, p[i].z, limit->step);
  const std::string remedy = fmt::format("lower {} or raise time.rotational_inertia_scale", state.model.step_key());
  const bool begins = state.clock.step() == 0 && state.filling.is_done();
  require(!begins || dt <= limit->step || state.model.scene.time.allow_unstable,
          "{}: {}, or set time.allow_unstable to see what it does", what, remedy);
  if (state.step_watch.warned) return;
  state.step_watch.warned = true;
  say(fmt::format("{}: clogs may shake; {}", what, remedy));
}

void StabilityWatch::look_for_shaking(RunState& state) const {
  const double rest = state.clog_watch.rest_speed();
  if (!(rest > 0) || !state.has_friction()) return;
  // A shaking pack goes and turns to and fro in two steps: its velocities at whole steps are those of rest.
  Speeds speeds = speeds_near_neck(state);
  const double shaking = quantile(speeds.between, slow_share);
  StepWatch& watch = state.step_watch;
  if (!(shaking > std::max(rest, watch.shaking)) || quantile(speeds.at, slow_share) > rest) return;
  if (watch.shaking == 0)
    say(fmt::format(
        "the pack shakes: near the neck particles go or turn to and fro at {:.3g} m/s from one step to the next, where "
        "below {:.3g} m/s would be rest; lower {} or raise time.rotational_inertia_scale",
        shaking, rest, state.model.step_key()));
  watch.shaking = shaking;
}

/// Steps between two looks at all overlaps of unequal spheres: no more than a contact lasts.
constexpr std::int64_t overlaps_every = 8;

void StabilityWatch::check_overlap(RunState& state) const {
  if (state.count() == 0) return;
  const double overlap = state.largest_overlap(), diameter = 2 * state.lists.pairs.smallest_radius;
  double share = overlap / diameter;
  if (share <= deep_overlap) return;
  // Of unequal spheres that is a bound; which contact has what share is looked for where it could matter.
  if (state.lists.pairs.equal_radius == 0 && std::isfinite(share)) {
    if (state.clock.step() % overlaps_every != 0) return;
    share = deepest_contact(state).share;
  }
  if (!(share <= deepest_overlap)) blow_up(state, "pressed too deep", deepest_contact(state).particle);
  if (state.step_watch.deep || share <= deep_overlap) return;
  state.step_watch.deep = true;
  const Scene::Contact& contact = state.model.scene.contact;
  const char* wrong = contact_traits(contact.law).knows_modulus ? "Hertz's law is off by 10 % and more"
                                                                : "spheres no longer touch in points";
  say(fmt::format("t = {:.6g} s, {}: beyond {} of a diameter {}; {}", state.time(),
                  contact_words(state, deepest_contact(state)), deep_overlap, wrong, overlap_remedy(contact)));
}

}  // namespace clogflow
