#include "dem/state/particles.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/base/expect.hpp"
#include "dem/state/valid.hpp"

namespace clogflow {

namespace {

template <class T>
void gather(std::vector<T>& values, const std::vector<int>& order) {
  expect(order.size() <= values.size() && (order.empty() || point_below(order, values.size())));
  std::vector<T> taken(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) taken[k] = values[order[k]];
  values.swap(taken);
}

}  // namespace

bool Particles::valid(double largest_radius) const {
  const auto possible = [&](const ParticleState& s) {
    for (double value : {s.x, s.y, s.z, s.radius, s.vx, s.vy, s.vz, s.mass, s.wx, s.wy, s.wz, s.inertia})
      if (!std::isfinite(value)) return false;
    return s.radius > 0 && s.mass > 0 && s.inertia > 0 && s.radius <= largest_radius;
  };
  return states.size() == size() && passed.size() == size() && species.size() == size() &&
         std::ranges::all_of(states, possible);
}

void Particles::add(const Particle& p) {
  expect(states.size() == size() && passed.size() == size() && species.size() == size());
  id.push_back(p.id);
  ParticleState state;
  state.x = p.x, state.y = p.y, state.z = p.z, state.radius = p.radius;
  state.vx = p.vx, state.vy = p.vy, state.vz = p.vz, state.mass = p.mass;
  state.wx = p.wx, state.wy = p.wy, state.wz = p.wz, state.inertia = p.inertia;
  states.push_back(state);
  passed.push_back(0);
  species.push_back(static_cast<std::uint8_t>(p.species));
}

void Particles::clear_loads() {
  for (ParticleState& s : states) s.fx = s.fy = s.fz = s.tx = s.ty = s.tz = s.no_force = s.no_torque = 0;
}

void Particles::reorder(const std::vector<int>& order) {
  gather(id, order);
  gather(states, order);
  gather(passed, order);
  gather(species, order);
}

double half_step_energy(const Particles& p) {
  double energy = 0;
  for (const ParticleState& s : p.states) energy += kinetic_energy(s, s.velocity(), s.spin());
  return energy;
}

ParticlePointers pointers(Particles& p) {
  auto* state = reinterpret_cast<double*>(p.states.data());
  return {p.states.data(), state, state + record_loads, p.species.data(), p.size()};
}

}  // namespace clogflow
