#include "dem/run/energy_account.hpp"

#include "coupling/base/require.hpp"
#include "dem/physics/drag.hpp"
#include "dem/run/present_network.hpp"
#include "dem/run/whole_step.hpp"
#include "dem/state/external_force.hpp"

namespace clogflow {

namespace {

/// Beyond any load: a slider with this coefficient never slips.
constexpr double endless_grip = 1e100;

ContactLaw sticking(ContactLaw law) {
  for (double* coefficient : {&law.friction.sliding, &law.friction.rolling, &law.friction.torsion})
    if (*coefficient > 0) *coefficient = endless_grip;
  return law;
}

Vec3 velocity_before(const RunState& s, int i) { return {s.particles[i].vx, s.particles[i].vy, s.particles[i].vz}; }

Vec3 spin_before(const RunState& s, int i) { return {s.particles[i].wx, s.particles[i].wy, s.particles[i].wz}; }

Vec3 velocity_after(const RunState& s, int i) {
  return velocity_before(s, i) + s.clock.kick() / s.particles[i].mass * total_force(s, i);
}

/// Of i against j, or against a wall.
template <class Velocity, class Spin>
ContactMotion<double> motion(const RunState& s, int i, int j, const Velocity& velocity, const Spin& spin) {
  const Vec3 none{0, 0, 0};
  if (j < 0) return {velocity(s, i), spin(s, i), none};
  return {velocity(s, i) - velocity(s, j), spin(s, i), spin(s, j)};
}

double power_of(const ContactLoads<double>& loads, const ContactMotion<double>& m) {
  return dot(loads.force, m.velocity) + dot(loads.torque_i, m.spin_i) + dot(loads.torque_j, m.spin_j);
}

double spring_energy(const ContactLaw& law, const ContactGeometry<double>& g, const Springs<double>& springs) {
  return law.stored_energy(g, springs) - law.stored_energy(g, {});
}

}  // namespace

struct EnergyAccount::Contact {
  int i, j;  // j < 0: a wall
  const ContactLaw& law;
  ContactGeometry<double> geometry;
  Springs<double> springs;
  double share;
  Vec3 place;
};

EnergyAccount::EnergyAccount(const Model& model) : model_(model) {
  const double radius = model.scene.particles.diameter / 2;
  require(model.laws.pair.reach(radius) == 0 && model.laws.wall.contact.reach(radius) == 0,
          "contact.law = one whose contacts stick (the energy account knows none): take another law");
}

void EnergyAccount::look(const RunState& state) {
  power_ = {};
  before_.swap(now_);
  now_.clear();
  add_pairs(state);
  add_walls(state);
  // What touches no more takes its springs' energy with it.
  for (const auto& [numbers, known] : before_) terms_.stiffening -= known.spring_energy;
  add_films(state);
  add_particles(state);
  if (has_last_power_) integrate(state.clock.dt());
  last_power_ = power_;
  has_last_power_ = true;
}

void EnergyAccount::integrate(double dt) {
  for (double EnergyTerms::*term :
       {&EnergyTerms::dashpots, &EnergyTerms::films, &EnergyTerms::drag, &EnergyTerms::body_force})
    terms_.*term += dt / 2 * (last_power_.*term + power_.*term);
}

void EnergyAccount::add_pairs(const RunState& state) {
  const auto& p = state.particles;
  state.lists.pairs.for_each_contact([&](int i, int j, Springs<double> springs) {
    if (p.id[i] > p.id[j]) std::swap(i, j), springs = swapped(springs);
    const PairPlace<double> place = pair_place(p, i, j);
    const double distance = place.distance();
    ContactGeometry<double> geometry =
        place.contact(1 / distance * place.apart, place.overlap(distance), reduced(p[i].mass, p[j].mass));
    if (state.lists.pairs.equal_radius == 0) geometry.turning = 1 / distance;  // as in the hot loop
    add_contact(state, {i, j, model_.laws.pair, geometry, springs, 1, Vec3::Zero()});
  });
}

void EnergyAccount::add_walls(const RunState& state) {
  const auto& p = state.particles;
  if (state.lists.walls.empty()) return;
  for (const auto& touch : state.lists.walls.touches(p)) {
    const int i = touch.particle;
    const Vec3& normal = touch.normal;
    add_contact(state, {i, -1, model_.laws.wall.contact, wall_contact(normal, touch.overlap, p[i].radius, p[i].mass),
                        touch.springs, touch.share, touch.point});
  }
}

void EnergyAccount::add_contact(const RunState& state, const Contact& c) {
  const ContactGeometry<double>& g = c.geometry;
  const std::pair numbers{state.particles.id[c.i], c.j < 0 ? -1 : state.particles.id[c.j]};
  const auto [begin, end] = before_.equal_range(numbers);
  const auto found = std::find_if(begin, end, [&](const auto& known) {
    return (known.second.place - c.place).norm() < same_place * g.radius || c.j >= 0;
  });
  Springs<double> springs{};
  if (found != end) {
    springs = found->second.springs;
    terms_.stiffening += c.share * spring_energy(c.law, g, springs) - found->second.spring_energy;
    before_.erase(found);
  }

  // The step of the hot loop once more, with and without Coulomb's limit, from the springs of the last step.
  const ContactMotion<double> moved = motion(state, c.i, c.j, velocity_before, spin_before);
  const auto& p = state.particles;
  const double x = c.j < 0 ? p[c.i].x : (p[c.i].x + p[c.j].x) / 2;
  const int own = p.species[c.i], other = c.j < 0 ? 0 : p.species[c.j];
  const ContactLaw law = state.present(c.law).at(x, own, other), never_slips = sticking(c.law.at(x, own, other));
  const double dt = state.clock.stretch_time();
  Springs<double> uncut = springs, held = c.springs;
  const ContactLoads<double> loads = law.loads(g, moved, dt, springs);
  never_slips.loads(g, moved, dt, uncut);
  terms_.sliders += c.share * (c.law.stored_energy(g, uncut) - c.law.stored_energy(g, c.springs));

  // What the springs do alone, as they stand, they give back; the rest of the loads is dashpots'.
  const ContactLoads<double> elastic = never_slips.loads(g, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, 0, held);
  const ContactMotion<double> moves = motion(state, c.i, c.j, velocity_now, spin_now);
  power_.dashpots += c.share * (power_of(elastic, moves) - power_of(loads, moves));
  now_.insert({numbers, {c.place, c.springs, c.share * spring_energy(c.law, g, c.springs)}});
}

void EnergyAccount::add_films(const RunState& state) {
  const bool implicit = model_.scene.time.integrator == Integrator::implicit_fluid;
  const auto speed = [&](const Film& film, const auto& velocity) {
    const Vec3 own = velocity(state, film.first);
    return dot(film.normal, film.second < 0 ? own : own - velocity(state, film.second));
  };
  for (const Film& film : present_films(state))
    power_.films +=
        film.coefficient * speed(film, implicit ? velocity_after : velocity_before) * speed(film, velocity_now);
}

void EnergyAccount::add_particles(const RunState& state) {
  AdvanceTask fluid{};
  state.fluid.attach(fluid);
  const bool implicit = model_.scene.time.integrator != Integrator::verlet;
  for (int i = 0; i < static_cast<int>(state.count()); ++i) {
    const ParticleState& p = state.particles[i];
    const Vec3 velocity = velocity_now(state, i);
    const Vec3 body = external_force(model_.scene, p.mass, p.radius);
    power_.body_force += dot(body, velocity);
    if (!fluid.drag) continue;
    const Vec3 other = Vec3{p.fx, p.fy, p.fz} + body;
    power_.drag += dot(total_force(state, i) - other, velocity);
    if (!fluid.turn) continue;
    const double rate = state.clock.kick() / p.inertia;
    const Vec3 contacts{p.tx, p.ty, p.tz}, turning{fluid.sx[i], fluid.sy[i], fluid.sz[i]};
    const Vec3 whole = contacts + fluid.turn[i] * (turning - spin_before(state, i));
    const double share = implicit ? implicit_drag_factor(rate * fluid.turn[i]) : 1;
    power_.drag += dot(share * whole - contacts, spin_now(state, i));
  }
}

}  // namespace clogflow
