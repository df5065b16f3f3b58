#include "dem/run/forces.hpp"

#include <algorithm>
#include <array>

#include "dem/run/present_network.hpp"
#include "dem/state/external_force.hpp"

namespace clogflow {

namespace {

bool has_implicit_films(const RunState& state) {
  return state.model.scene.time.integrator == Integrator::implicit_fluid;
}

void clear_unused_loads(RunState& state) {
  if (!state.loads_are_clear) state.particles.clear_loads();
  state.loads_are_clear = false;
}

ContactTally collide_walls(RunState& state, const Kernels& kernels) {
  WallLaws laws = state.model.laws.wall;
  laws.contact = state.present(laws.contact);
  laws.dt = state.clock.stretch_time();
  if (has_implicit_films(state)) laws.lubrication = {};
  WallContacts& walls = state.lists.walls;
  ContactTally tally = walls.collide_planes(state.particles, kernels, laws);
  const ContactTally corners = walls.collide_corners(state.particles, laws);
  tally.contacts += corners.contacts;
  tally.largest_overlap = std::max(tally.largest_overlap, corners.largest_overlap);
  return tally;
}

}  // namespace

void sum_contacts(RunState& state, const Kernels& kernels) {
  clear_unused_loads(state);
  const Laws& laws = state.model.laws;
  Neighbours& n = state.lists.pairs;
  state.pair_tally = kernels.collide_pairs({pointers(state.particles), n.contacts.pointers(), state.present(laws.pair),
                                            has_implicit_films(state) ? LubricationLaw{} : laws.film,
                                            state.clock.stretch_time(), n.equal_radius, n.equal_mass},
                                           laws.pair_terms);
  state.wall_tally = collide_walls(state, kernels);
}

void meet_fluid(RunState& state) {
  // The channel is filled and comes to rest in the mean flow.
  if (!state.filling.gate_is_closed()) state.fluid.fluctuate(state.particles, state.seed, state.time());
  // A laboratory that is stepped by hand is never filled.
  const bool fills = state.filling.has_begun() && !state.filling.is_done();
  state.fluid.drive().prescribe(state.time(), !fills);
  state.fluid.evaluate(state.particles);
  if (state.fluid.drive().is_balancing()) state.fluid.balance(advance_task(state), state.clock.dt());
  if (has_implicit_films(state)) add_implicit_films(advance_task(state), present_films(state));
}

AdvanceTask advance_task(RunState& state) {
  const Scene& s = state.model.scene;
  AdvanceTask task{};
  task.particles = pointers(state.particles);
  state.fluid.attach(task);
  const double equal_mass = state.lists.pairs.equal_mass;
  const bool mixed = mixes_densities(s);
  const Vec3 external =
      equal_mass > 0 ? external_force(s, equal_mass, state.lists.pairs.equal_radius) : Vec3(s.body_force);
  for (int a = 0; a < 3; ++a) {
    task.body_force[a] = std::array{external.x, external.y, external.z}[a];
    if (equal_mass > 0 || s.gravity[a] == 0) continue;
    task.weighs = true;
    task.floats = mixed;
    task.weight_per_mass[a] =
        mixed ? s.gravity[a] / s.time.mass_scale : weight_per_mass(s, s.gravity[a], s.particles.density);
    task.buoyancy[a] = mixed ? buoyancy_per_cube(s, s.gravity[a]) : 0;
  }
  task.kick = state.clock.kick();
  task.drift = state.clock.dt();
  task.mass = equal_mass, task.inertia = state.lists.pairs.equal_inertia;
  task.implicit_drag = s.time.integrator != Integrator::verlet;
  task.passage = state.model.domain.passage;
  task.too_fast = longest_way * state.lists.pairs.smallest_radius / state.clock.dt();
  return task;
}

}  // namespace clogflow
