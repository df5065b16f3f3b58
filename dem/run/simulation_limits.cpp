// How near a run is to its largest stable step, and whether it has begun to blow up.

#include <algorithm>
#include <cmath>

#include "coupling/base/quantile.hpp"
#include "coupling/base/require.hpp"
#include "dem/physics/lubrication.hpp"
#include "dem/run/simulation.hpp"
#include "dem/stability/step_limit.hpp"
#include "dem/state/initial_particles.hpp"

namespace clogflow {

NetworkLimit Simulation::network() const {
  const auto& p = particles_;
  NetworkLimit network(p);
  for (std::size_t k = 0; k < neighbours_.contacts.size(); ++k)
    add_pair(network, neighbours_.contacts.first(k), neighbours_.contacts.second(k));
  const Integrator integrator = model_.scene.time.integrator;
  if (integrator != Integrator::implicit_fluid)
    for (const Film& film : films()) network.add_film(film.first, film.second, film.normal, film.coefficient);
  if (!walls_.empty())
    for (const auto& touch : walls_.touches(p)) {
      const int i = touch.particle;
      const double overlap = std::max(touch.overlap, -model_.laws.wall.contact.reach(p[i].radius));
      network.add_contact(
          i, -1,
          model_.laws.wall.contact.modes(
              model_.laws.wall.terms,
              wall_contact({touch.normal.x(), touch.normal.y(), touch.normal.z()}, overlap, p[i].radius, p[i].mass)));
    }
  AdvanceTask fluid{};
  fluid_.attach(fluid);
  for (std::size_t i = 0; fluid.drag && i < p.size(); ++i)
    network.add_drag(static_cast<int>(i),
                     {fluid.drag[i], fluid.turn ? fluid.turn[i] : 0, integrator != Integrator::verlet});
  return network;
}

void Simulation::add_pair(NetworkLimit& network, int i, int j) const {
  const auto& p = particles_;
  const PairPlace<double> place = pair_place(p, i, j);
  const double distance = place.distance();
  const double overlap = std::max(place.overlap(distance), -model_.laws.pair.reach(place.effective_radius()));
  network.add_contact(
      i, j,
      model_.laws.pair.modes(model_.laws.pair_terms, place.contact(distance, overlap, reduced(p[i].mass, p[j].mass))));
}

std::vector<Film> Simulation::films() const {
  const auto& p = particles_;
  std::vector<Film> films;
  const auto add = [&](int i, int j, const LubricationLaw& law, const Vector<double>& normal, double radius, double gap,
                       double share = 1) {
    const double coefficient = film_coefficient(law, radius, gap, 1.0);
    if (coefficient > 0) films.push_back({i, j, normal, share * coefficient});
  };
  const auto add_pair = [&](int i, int j) {
    const PairPlace<double> place = pair_place(p, i, j);
    const double distance = place.distance();
    add(i, j, model_.laws.film, (1 / distance) * place.apart, place.effective_radius(),
        distance - p[i].radius - p[j].radius);
  };
  if (model_.laws.film.viscosity > 0) {
    const Neighbours& n = neighbours_;
    for (std::size_t k = 0; k < n.first.size(); ++k) add_pair(n.first[k], n.second[k]);
  }
  const LubricationLaw& law = model_.laws.wall.lubrication;
  if (law.viscosity > 0 && !walls_.empty())
    for (const auto& wall : walls_.gaps(p, law.farthest))
      add(wall.particle, -1, law, {wall.normal.x(), wall.normal.y(), wall.normal.z()}, p[wall.particle].radius,
          wall.width, wall.share);
  return films;
}

void Simulation::announce_step() {
  const InitialParticles initial = read_initial_file(model_.scene);
  const StepLimits limits = expected_limits(model_, initial.particles);
  data_.record.step_limits = describe(limits, model_.dt);
  if (say_) say_(describe(limits, model_.dt));
  if (say_ && !initial.note.empty()) say_(initial.note);
  if (say_ && !model_.walls_note.empty()) say_(model_.walls_note);
  if (const std::string warning = check_step(limits, model_); say_ && !warning.empty()) say_(warning);
  for (const std::string& warning : {way_warning(limits, model_.dt), impact_warning(limits, model_.dt)})
    if (say_ && !warning.empty()) say_(warning);
}

void Simulation::watch_step() {
  if (step_ % look_every != 0 || particles_.size() == 0) return;
  look_at_limit();
  look_for_shaking();
  const double stored = kinetic_energy() + elastic_energy();
  if (step_watch_.appeared(stored, drag_work_ + body_work_ + energy_in_)) blow_up("energy from nothing", fastest());
}

void Simulation::look_at_limit() {
  const NetworkLimit network = this->network();
  const NetworkLimit::Bound bound = network.bound();
  const double dt = model_.dt;
  const bool near = dt > near_limit * bound.step;
  const bool stiffer = bound.step < (1 - NetworkLimit::resolution) * step_watch_.smallest_bound;
  if (!stiffer && !(near && step_ % look_at_whole_every == 0)) return;
  if (stiffer) step_watch_.smallest_bound = bound.step;
  // The bound is safe; whether a step near it is, the whole network says.
  const double limit = near ? network.exact(bound) : bound.step;
  step_watch_.smallest_limit = std::min(step_watch_.smallest_limit, limit);
  if (dt <= near_limit * limit) return;
  const auto& p = particles_;
  const int i = bound.particle;
  const std::string what = fmt::format(
      "the step of {:.3g} s is {} the limit of the contacts of particle {} at ({:.4g}, {:.4g}, {:.4g}) m, "
      "{:.3g} s",
      dt, dt > limit ? "above" : "near", p.id[i], p[i].x, p[i].y, p[i].z, limit);
  const std::string remedy = fmt::format("lower {} or raise time.rotational_inertia_scale", model_.step_key());
  const bool begins = step_ == 0 && filling_.stage == Filling::Stage::done;
  require(!begins || dt <= limit || model_.scene.time.allow_unstable,
          "{}: {}, or set time.allow_unstable to see what it does", what, remedy);
  if (step_watch_.warned) return;
  step_watch_.warned = true;
  if (say_) say_(fmt::format("{}: clogs may shake; {}", what, remedy));
}

void Simulation::look_for_shaking() {
  const double rest = watch_.rest_speed();
  if (!(rest > 0) || filling_.stage == Filling::Stage::tap || watch_.friction_off()) return;
  // A shaking pack goes and turns to and fro in two steps: its velocities at whole steps are those of rest.
  const auto& p = particles_;
  const auto speed = [](const Vector<double>& v, const Vector<double>& w, double radius) {
    return std::max(std::sqrt(dot(v, v)), radius * std::sqrt(dot(w, w)));
  };
  std::vector<double> between, at;
  for (const int i : near_neck(p, model_.scene)) {
    between.push_back(speed({p[i].vx, p[i].vy, p[i].vz}, {p[i].wx, p[i].wy, p[i].wz}, p[i].radius));
    at.push_back(speed(velocity_now(i), spin_now(i), p[i].radius));
  }
  const double shaking = quantile(between, slow_share);
  if (!(shaking > std::max(rest, step_watch_.shaking)) || quantile(at, slow_share) > rest) return;
  if (say_ && step_watch_.shaking == 0)
    say_(fmt::format(
        "the pack shakes: near the neck particles go or turn to and fro at {:.3g} m/s from one step to the next, where "
        "below {:.3g} m/s would be rest; lower {} or raise time.rotational_inertia_scale",
        shaking, rest, model_.step_key()));
  step_watch_.shaking = shaking;
}

double Simulation::kinetic_energy() const {
  double energy = 0;
  for (int i = 0; i < static_cast<int>(particles_.size()); ++i)
    energy += clogflow::kinetic_energy(particles_[i], velocity_now(i), spin_now(i));
  return energy;
}

void Simulation::check_overlap() {
  if (particles_.size() == 0) return;
  const double overlap = largest_overlap();
  if (!(overlap <= deepest_overlap * 2 * neighbours_.smallest_radius)) blow_up("pressed too deep", deepest().particle);
  if (step_watch_.deep || overlap <= deep_overlap * 2 * neighbours_.smallest_radius) return;
  step_watch_.deep = true;
  if (say_)
    say_(fmt::format(
        "t = {:.6g} s, {}: beyond {} of a diameter Hertz's law is off by 10 % and more; raise contact.youngs_modulus",
        time(), describe_contact(deepest()), deep_overlap));
}

std::string Simulation::describe_contact(const Deepest& contact) const {
  const auto& p = particles_;
  const ParticleState& at = p[contact.particle];
  const double smaller = contact.other < 0 ? at.radius : std::min(at.radius, p[contact.other].radius);
  return fmt::format("particle {} at ({:.4g}, {:.4g}, {:.4g}) m overlaps {} by {:.3g} m, {:.2g} of its diameter",
                     p.id[contact.particle], at.x, at.y, at.z,
                     contact.other < 0 ? "a wall" : fmt::format("particle {}", p.id[contact.other]), contact.overlap,
                     contact.overlap / (2 * smaller));
}

int Simulation::fastest() const {
  const auto& p = particles_;
  int worst = 0;
  double fastest = -1;
  for (std::size_t i = 0; i < p.size(); ++i) {
    // Not std::hypot: of (0, NaN, 0) libstdc++ 12 makes 0, and the culprit would not be named.
    const double speed = std::sqrt(p[i].vx * p[i].vx + p[i].vy * p[i].vy + p[i].vz * p[i].vz);
    if (speed <= fastest) continue;
    worst = static_cast<int>(i);
    fastest = speed;
    if (std::isnan(speed)) break;
  }
  return worst;
}

Simulation::Deepest Simulation::deepest() const {
  const auto& p = particles_;
  Deepest worst;
  const auto look = [&](int i, int j, double overlap) {
    if (!(overlap <= worst.overlap)) worst = {i, j, overlap};
  };
  const ContactSet& pairs = neighbours_.contacts;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const int i = pairs.first(k), j = pairs.second(k);
    const PairPlace<double> place = pair_place(p, i, j);
    look(i, j, place.overlap(place.distance()));
  }
  if (!walls_.empty())
    for (const auto& touch : walls_.touches(p)) look(touch.particle, -1, touch.overlap);
  return worst;
}

/// What may be done about a run that ends, by what is known of it.
std::string Simulation::remedy(const ParticleState& worst) const {
  const double speed = std::sqrt(worst.vx * worst.vx + worst.vy * worst.vy + worst.vz * worst.vz);
  if (!std::isfinite(speed) || !std::isfinite(worst.x + worst.y + worst.z))
    return "a number became infinite or none; look for two particles in one place, or lower " +
           std::string(model_.step_key());
  // A force of the first step may be the start's or the step's: only a start that is too deep is known to be the
  // start's.
  if (particle_steps_ == 0 && largest_overlap() > deepest_overlap * 2 * neighbours_.smallest_radius)
    return "it begins so: move particles apart, or away from the walls";
  return fmt::format("lower {} or raise contact.youngs_modulus", model_.step_key());
}

void Simulation::blow_up(const char* cause, int particle) const {
  const ParticleState& worst = particles_[particle];
  const Deepest contact = deepest();
  // Thrown apart, they touch no more: what they were before the step is known from its forces.
  const std::string touch =
      contact.overlap > 0 ? describe_contact(contact) : fmt::format("largest overlap {:.3g} m", largest_overlap());
  throw Error(
      fmt::format("blow-up at step {} (t = {:.6g} s), {}: particle {} at ({:.4g}, {:.4g}, {:.4g}) m moves at "
                  "{:.3g} m/s under a force of {:.3g} N, {}; {}",
                  step_, time(), cause, particles_.id[particle], worst.x, worst.y, worst.z,
                  std::sqrt(worst.vx * worst.vx + worst.vy * worst.vy + worst.vz * worst.vz),
                  Vec3(worst.fx, worst.fy, worst.fz).norm(), touch, remedy(worst)));
}

}  // namespace clogflow
