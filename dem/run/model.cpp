#include "dem/run/model.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/base/require.hpp"
#include "coupling/flow/channel_drop.hpp"
#include "coupling/flow/flow_flux.hpp"
#include "coupling/flow/flow_rescale.hpp"
#include "coupling/geometry/channel_geometry.hpp"
#include "coupling/geometry/channel_shape.hpp"
#include "coupling/geometry/stl_surface.hpp"
#include "dem/physics/drag.hpp"
#include "dem/physics/porosity.hpp"
#include "dem/physics/time_step.hpp"
#include "dem/run/model_walls.hpp"
#include "dem/stability/pack_estimates.hpp"
#include "dem/state/initial_particles.hpp"

namespace clogflow {

namespace {

/// Shares of the diameter: how far a slow particle may go before the lists are made anew, and the fastest. They change
/// the cost only; tuned in flow at D/d = 3.
constexpr double least_room_share = 0.05, widest_room_share = 0.3;

/// v in v_c = 0.1 v of what a flow carries; v itself of what falls, or the fastest initial particle where nothing
/// drives.
double collision_speed(const Scene& scene, const std::vector<Particle>& initial) {
  if (scene.flow_speed() > 0) return collision_speed_share * scene.flow_speed();
  double fastest = scene.speed_scale();
  for (const Particle& p : initial) fastest = std::max(fastest, p.velocity().norm());
  return fastest;
}

/// What a count of 64 bits holds; no machine gets there, a wrong unit does.
constexpr double most_steps = 1e18;

void choose_step(Model& model, const std::vector<Particle>& initial) {
  const Scene& s = model.scene;
  const double speed = collision_speed(s, initial);
  for (std::size_t k = 0; speed > 0 && k < model.sizes.species(); ++k) {
    double smallest = model.sizes.of(k).smallest();
    for (const Particle& p : initial) smallest = std::min(smallest, 2 * p.radius);
    const Impact impact{model.sizes.density(k) * s.time.mass_scale, smallest, speed};
    const double time = std::min(model.laws.pair.contact_time(impact), model.laws.wall.contact.contact_time(impact));
    model.contact_time = k == 0 ? time : std::min(model.contact_time, time);
  }
  model.dt = s.time.step;
  if (model.dt == 0) {
    require(speed > 0,
            "time.step is missing (nothing moves in this scene, so no contact time can be "
            "derived): give time.step, e.g. \"1e-7 s\"");
    // Whatever the end: a run that is lengthened goes on with the step it began with.
    model.dt = s.time.step_fraction * model.contact_time;
    if (s.time.contact_limit_share > 0)
      model.dt = std::min(model.dt, s.time.contact_limit_share * expected_limits(model, initial).contacts);
  }
  require(
      s.time.end / model.dt < most_steps,
      "time.end = {} s (would take {:.2g} steps of {:.3g} s, more than {:.0g}): lower it, or let the step be longer",
      s.time.end, s.time.end / model.dt, model.dt, most_steps);
  model.steps = static_cast<std::int64_t>(std::llround(std::ceil(s.time.end / model.dt - 1e-9)));
}

/// A sphere that turns further in a step knows no direction of sliding; its spin is a mistake [rad].
constexpr double furthest_turn = 1;

void check_spins(const Model& model, const std::vector<Particle>& initial) {
  for (std::size_t k = 0; k < initial.size(); ++k) {
    const Particle& p = initial[k];
    const double turn = model.dt * std::max({std::abs(p.wx), std::abs(p.wy), std::abs(p.wz)});
    require(turn < furthest_turn,
            "particle {} of {} turns by {:.3g} rad in a step of {:.3g} s (allowed {} rad): lower its spin or the step",
            k + 1, model.scene.particles.initial.empty() ? "those given" : model.scene.particles.initial, turn,
            model.dt, furthest_turn);
  }
}

/// A wanted fidelity must have become numbers before: silence would be taken for a result.
void refuse_unresolved(const Scene& s) {
  require(s.fidelity.preset.empty() && s.fidelity.tolerance == 0,
          "fidelity.{} has not been turned into keys of the scene: read the scene through the program clog",
          s.fidelity.preset.empty() ? "tolerance" : "preset");
}

double flow_rate(const Scene& s) { return channel_flow_rate(s.geometry, s.flow.mean_velocity); }

FlowFactors flow_factors(const Scene& scene, const FlowGrid* flow) {
  const Oscillation oscillation(scene);
  check_return(scene, oscillation);
  const double k = oscillation.largest();
  FlowFactors factors{k, k};
  const auto drops = expected_drops(scene, flow);
  if (!drops) return factors;
  const bool compliant = scene.flow.compliance > 0;
  const double drop = compliant ? drops->channel + drops->pack : scene.flow.pressure_drop;
  return {k * drop / drops->channel, k * drops->mean_factor(drop)};
}

/// More than any one core finishes; a diameter with a wrong unit gets here.
constexpr double most_particles = 1e8;

void check_count(const Scene& s) {
  if (!s.inlet.enabled || !s.geometry.present) return;
  const double count =
      channel_volume(s.geometry, channel_start(s.geometry), 0) / ParticleSizes(s.particles).mean_volume();
  require(count < most_particles,
          "particles.diameter = {} m (the channel would hold {:.2g} particles, more than {:.0g}): raise it",
          s.particles.diameter, count, most_particles);
}

}  // namespace

const char* Model::step_key() const {
  const auto& t = scene.time;
  if (t.step > 0) return "time.step";
  // The fraction alone gave a longer step; steps are rounded to divide the time.
  const bool shared = t.contact_limit_share > 0 && dt < 0.99 * t.step_fraction * contact_time;
  return shared ? "time.contact_limit_share" : "time.step_fraction";
}

Particle Model::particle(const ParticleSizes::Drawn& drawn) const {
  Particle particle = particle_at_rest(scene, drawn.diameter / 2, sizes.density(drawn.species));
  particle.species = drawn.species;
  return particle;
}

StepLimits expected_limits(const Model& model, const std::vector<Particle>& initial) {
  return expected_limits({.scene = model.scene,
                          .laws = model.laws,
                          .contact_time = model.contact_time,
                          .has_walls = !model.walls.empty(),
                          .factors = model.factors},
                         initial);
}

std::string check_step(const StepLimits& limits, const Model& model) {
  return check_step(limits, {.dt = model.dt,
                             .key = model.step_key(),
                             .allow_unstable = model.scene.time.allow_unstable,
                             .contact = model.scene.contact});
}

Model make_model(const Scene& scene, const FlowGrid* flow, const std::vector<Particle>& initial) {
  refuse_unresolved(scene);
  check_count(scene);
  if (flow) {
    require(scene.flow.source == FlowSource::openfoam,
            "flow.source is not \"openfoam\", so a flow file is of no use: leave it out");
    check_flow_belongs(scene, *flow);
    if (is_channel(scene)) check_flow_fits(*flow, scene);
  }
  Model model;
  model.scene = scene;
  model.sizes = ParticleSizes(scene.particles);
  model.laws = make_laws(scene);
  double largest = model.sizes.largest() / 2;
  for (const Particle& p : initial) largest = std::max(largest, p.radius);
  model.reach = {
      2 * widest_room_share * scene.particles.diameter,
      std::max({model.laws.film.farthest, model.laws.pair.reach(largest / 2), model.laws.wall.contact.reach(largest)})};
  model.reach.least_room = least_room_share * scene.particles.diameter;
  if (!model.sizes.equal()) {
    // Contacts that stick reach less than in proportion to their size.
    const double least = smallest_radius(scene, initial) / 2;
    model.reach.by_size = true;
    model.reach.per_radius = std::max(model.laws.film.per_radius, model.laws.pair.reach(least) / least);
  }
  model.largest_radius = scene.inlet.enabled ? model.sizes.largest() / 2 : 0;
  for (const Particle& p : initial) model.largest_radius = std::max(model.largest_radius, p.radius);
  model.factors = flow_factors(scene, flow);
  build_walls(model, flow);
  model.weld = weld_length(model.walls, scene.geometry);
  choose_step(model, initial);
  check_spins(model, initial);
  model.laws.wall.dt = model.dt;
  return model;
}

std::optional<ExpectedDrops> expected_drops(const Scene& s, const FlowGrid* flow) {
  if (!s.flow.balances()) return std::nullopt;
  const std::optional<double> channel = flow ? solved_pressure_drop(*flow, s) : estimated_pressure_drop(s);
  if (!channel) return std::nullopt;
  ExpectedDrops drops{*channel, 0};
  if (!s.inlet.enabled) return drops;
  constexpr double profile = 1.3;  // <V0^2> / <V0>^2
  const double v = s.flow.mean_velocity, d = s.particles.diameter;
  const double count =
      (1 - pack_porosity) * channel_volume(s.geometry, channel_start(s.geometry), 0) / sphere_volume(d / 2);
  drops.pack = count * drag_law(s).slow_factor(pack_porosity) * stokes_coefficient(s.fluid.viscosity, d) * profile * v *
               v / (pack_porosity * flow_rate(s));
  return drops;
}

namespace {

PorosityStrips make_strips(const Scene& scene) {
  const auto& g = scene.geometry;
  const double start = channel_start(g), step = -start / scene.porosity.strips;
  std::vector<double> volumes;
  for (int k = 0; k < scene.porosity.strips; ++k)
    volumes.push_back(channel_volume(g, start + k * step, start + (k + 1) * step));
  PorosityStrips strips(start, 0, volumes, overlap_remedy(scene.contact, ", "));
  if (scene.porosity.neck) strips.add_neck(g.neck_length, channel_volume(g, 0, g.neck_length));
  return strips;
}

LocalPorosity make_local(const Scene& scene, const FlowGrid* flow) {
  const auto& g = scene.geometry;
  std::string said_already;
  return {{open_channel(scene, flow, said_already), channel_start(g), channel_end(g)}, scene.porosity.width};
}

}  // namespace

Fluid make_fluid(const Scene& scene, const FlowGrid* flow) {
  FlowField field;
  if (scene.flow.source == FlowSource::uniform) field = FlowField(scene.flow.velocity);
  if (scene.flow.source == FlowSource::openfoam) {
    require(flow != nullptr, "flow.source = \"openfoam\" needs the flow: give --flow flow.h5");
    field = FlowField(*flow, scene.flow.lookup);
  }
  PorosityStrips strips;
  LocalPorosity local;
  if (scene.geometry.present) {
    if (scene.porosity.strips > 0) strips = make_strips(scene);
    if (scene.porosity.method == PorosityMethod::local) local = make_local(scene, flow);
  }
  Fluid fluid(scene, field, std::move(strips), std::move(local));
  if (scene.flow.balances()) fluid.drive() = FlowDrive(scene, {solved_pressure_drop(*flow, scene), flow_rate(scene)});
  return fluid;
}

}  // namespace clogflow
