#include "dem/run/whole_step.hpp"
#include "dem/state/external_force.hpp"

namespace clogflow {

Vec3 total_force(const RunState& state, int i) {
  const auto& p = state.particles;
  const auto& scene = state.model.scene;
  const Vec3 other = Vec3{p[i].fx, p[i].fy, p[i].fz} + external_force(scene, p[i].mass, p[i].radius);
  const Vec3 velocity = p[i].velocity();
  return other + (scene.time.integrator == Integrator::verlet
                      ? state.fluid.drag_force(i, velocity)
                      : state.fluid.implicit_drag_force(i, velocity, other, state.clock.kick() / p[i].mass));
}

Vec3 velocity_now(const RunState& state, int i) {
  const auto& p = state.particles;
  const Vec3 velocity = p[i].velocity();
  return velocity + state.clock.lag() / p[i].mass * total_force(state, i);
}

Vec3 spin_now(const RunState& state, int i) {
  const auto& p = state.particles;
  const Vec3 spin = p[i].spin();
  return spin + state.clock.lag() / p[i].inertia * Vec3{p[i].tx, p[i].ty, p[i].tz};
}

double kinetic_energy(const RunState& state) {
  double energy = 0;
  for (int i = 0; i < static_cast<int>(state.count()); ++i)
    energy += kinetic_energy(state.particles[i], velocity_now(state, i), spin_now(state, i));
  return energy;
}

double elastic_energy(const RunState& state) {
  const auto& p = state.particles;
  const Laws& laws = state.model.laws;
  const WallContacts& walls = state.lists.walls;
  double energy = walls.empty() ? 0 : walls.stored_energy(p, laws.wall.contact);
  state.lists.pairs.for_each_contact([&](int i, int j, const Springs<double>& springs) {
    const PairPlace<double> place = pair_place(p, i, j);
    const double distance = place.distance();
    energy += laws.pair.stored_energy(
        place.contact(1 / distance * place.apart, place.overlap(distance), reduced(p[i].mass, p[j].mass)), springs);
  });
  return energy;
}

}  // namespace clogflow
