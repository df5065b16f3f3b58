#include "dem/run/forces.hpp"

#include <algorithm>
#include <array>

#include "dem/kernels/blocks.hpp"
#include "dem/kernels/stretch.hpp"
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

void add(ContactTally& sum, const ContactTally& tally) {
  sum.contacts += tally.contacts;
  sum.largest_overlap = std::max(sum.largest_overlap, tally.largest_overlap);
}

ContactTally collide_walls(RunState& state, const Kernels& kernels) {
  WallLaws laws = state.model.laws.wall;
  laws.contact = state.present(laws.contact);
  laws.dt = state.clock.stretch_time();
  if (has_implicit_films(state)) laws.lubrication = {};
  WallContacts& walls = state.lists.walls;
  ContactTally tally = walls.collide_planes(state.particles, kernels, laws);
  add(tally, walls.collide_corners(state.particles, laws));
  return tally;
}

}  // namespace

void sum_contacts(RunState& state, const Kernels& kernels) {
  clear_unused_loads(state);
  const Laws& laws = state.model.laws;
  Neighbours& n = state.lists.pairs;
  const ContactLaw law = state.present(laws.pair);
  const LubricationLaw film = has_implicit_films(state) ? LubricationLaw{} : laws.film;
  std::vector<ContactTally> tallies(n.groups.size());
  n.for_each_group(state.team, [&](PairGroup& group, std::size_t number) {
    tallies[number] = kernels.collide_pairs({pointers(state.particles), group.contacts.pointers(), law, film,
                                             state.clock.stretch_time(), n.equal_radius, n.equal_mass},
                                            laws.pair_terms);
  });
  state.pair_tally = {};
  for (const ContactTally& tally : tallies) add(state.pair_tally, tally);
  state.wall_tally = collide_walls(state, kernels);
}

void meet_fluid(RunState& state) {
  // The channel is filled and comes to rest in the mean flow.
  if (!state.filling.gate_is_closed()) state.fluid.fluctuate(state.particles, state.seed, state.time());
  // A laboratory that is stepped by hand is never filled.
  const bool fills = state.filling.has_begun() && !state.filling.is_done();
  state.fluid.drive().prescribe(state.time(), !fills);
  state.fluid.evaluate(state.particles, state.team);
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
  task.too_fast = too_fast(state);
  return task;
}

double too_fast(const RunState& state) { return longest_way * state.lists.pairs.smallest_radius / state.clock.dt(); }

AdvanceTally advance_all(RunState& state, const Kernels& kernels) {
  const AdvanceTask task = advance_task(state);
  const Blocks blocks(state.count());
  std::vector<AdvanceTally> tallies(static_cast<std::size_t>(blocks.count()));
  state.team.each(blocks.count(), [&](int k) {
    tallies[static_cast<std::size_t>(k)] = kernels.advance(stretch_of(task, blocks.begin(k), blocks.end(k)));
  });
  AdvanceTally sum;
  for (const AdvanceTally& tally : tallies) {
    sum.drag_work += tally.drag_work;
    sum.body_work += tally.body_work;
    sum.crossed |= tally.crossed;
    // Not max(): a NaN must get in and stay, whatever follows it.
    if (!(tally.largest_speed <= sum.largest_speed)) sum.largest_speed = tally.largest_speed;
  }
  return sum;
}

}  // namespace clogflow
