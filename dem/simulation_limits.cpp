// How near a run is to its largest stable step, and whether it has begun to blow up.

#include <algorithm>
#include <cmath>

#include "coupling/require.hpp"
#include "dem/initial_particles.hpp"
#include "dem/physics/lubrication.hpp"
#include "dem/simulation.hpp"
#include "dem/step_limit.hpp"

namespace clog {

namespace {

/// A particle that moves farther than this share of its radius in one step has been thrown.
constexpr double longest_way = 0.5;

Vector<double> apart(const Particles& p, int i, int j) {
  return {p.x[i] - p.x[j], p.y[i] - p.y[j], p.z[i] - p.z[j]};
}

}  // namespace

NetworkLimit::Bound Simulation::network_limit() const {
  const auto& p = particles_;
  NetworkLimit network(p);
  for (std::size_t k = 0; k < neighbours_.contacts.size(); ++k)
    add_pair(network, neighbours_.contacts.first(k), neighbours_.contacts.second(k));
  if (model_.lubrication.viscosity > 0)
    for (std::size_t k = 0; k < neighbours_.first.size(); ++k)
      add_film(network, neighbours_.first[k], neighbours_.second[k]);
  if (!walls_.empty())
    for (const auto& touch : walls_.touches(p)) {
      const int i = touch.particle;
      const double overlap = std::max(touch.overlap, 0.0);
      network.add_contact(i, -1,
                          contact_modes(model_.wall_laws.contact, model_.wall_laws.terms,
                                        {{touch.normal.x(), touch.normal.y(), touch.normal.z()}, overlap,
                                         p.radius[i], p.mass[i], p.radius[i] - overlap / 2, 0}));
    }
  AdvanceTask fluid{};
  fluid_.attach(fluid);
  const bool implicit = model_.scene.time.integrator != Integrator::verlet;
  for (std::size_t i = 0; fluid.drag && i < p.size(); ++i)
    network.add_drag(static_cast<int>(i), {fluid.drag[i], fluid.turn ? fluid.turn[i] : 0, implicit});
  return network.bound();
}

void Simulation::add_pair(NetworkLimit& network, int i, int j) const {
  const auto& p = particles_;
  const Vector<double> between = apart(p, i, j);
  const double distance = std::sqrt(dot(between, between));
  const double overlap = std::max(p.radius[i] + p.radius[j] - distance, 0.0);
  network.add_contact(i, j,
                      contact_modes(model_.pair_law, model_.pair_terms,
                                    {(1 / distance) * between, overlap,
                                     p.radius[i] * p.radius[j] / (p.radius[i] + p.radius[j]),
                                     p.mass[i] * p.mass[j] / (p.mass[i] + p.mass[j]),
                                     p.radius[i] - overlap / 2, p.radius[j] - overlap / 2}));
}

void Simulation::add_film(NetworkLimit& network, int i, int j) const {
  const auto& p = particles_;
  const auto& film = model_.lubrication;
  const Vector<double> between = apart(p, i, j);
  const double distance = std::sqrt(dot(between, between)), gap = distance - p.radius[i] - p.radius[j];
  if (gap < 0 || gap > film.farthest || (gap < film.nearest && !film.clamp)) return;
  network.add_film(i, j, (1 / distance) * between,
                   lubrication_coefficient(film.viscosity,
                                           p.radius[i] * p.radius[j] / (p.radius[i] + p.radius[j]),
                                           std::max(gap, film.nearest)));
}

void Simulation::announce_step() {
  const StepLimits limits = expected_limits(model_, read_initial_particles(model_.scene));
  data_.provenance["step_limits"] = describe(limits, model_.dt);
  if (say_) say_(describe(limits, model_.dt));
  if (const std::string warning = check_step(limits, model_); say_ && !warning.empty()) say_(warning);
}

void Simulation::watch_step() {
  if (step_ % look_every != 0 || particles_.size() == 0) return;
  const NetworkLimit::Bound bound = network_limit();
  step_watch_.smallest_limit = std::min(step_watch_.smallest_limit, bound.step);
  if (!step_watch_.warned && model_.dt > near_limit * bound.step) {
    step_watch_.warned = true;
    const auto& p = particles_;
    const int i = bound.particle;
    if (say_)
      say_(fmt::format("the step of {:.3g} s is {} the limit of the contacts of particle {} at ({:.4g}, "
                       "{:.4g}, {:.4g}) m, {:.3g} s: clogs may shake; lower time.step_fraction or "
                       "raise time.rotational_inertia_scale",
                       model_.dt, model_.dt > bound.step ? "above" : "near", p.id[i], p.x[i], p.y[i],
                       p.z[i], bound.step));
  }
  const double stored = kinetic_energy() + elastic_energy();
  if (step_watch_.appeared(stored, drag_work_ + body_work_ + energy_in_)) blow_up("energy from nothing");
}

double Simulation::kinetic_energy() const {
  const auto& p = particles_;
  double energy = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vector<double> v = velocity_now(static_cast<int>(i)), w = spin_now(static_cast<int>(i));
    energy += 0.5 * p.mass[i] * dot(v, v) + 0.5 * p.inertia[i] * dot(w, w);
  }
  return energy;
}

void Simulation::check(const AdvanceTally& tally) const {
  if (particles_.size() == 0) return;
  const double least = neighbours_.smallest_radius;
  const double overlap = std::max(pair_tally_.largest_overlap, wall_tally_.largest_overlap);
  if (!(tally.largest_speed * model_.dt <= longest_way * least)) blow_up("thrown");
  if (!(overlap <= deepest_overlap * 2 * least)) blow_up("pressed too deep");
}

void Simulation::blow_up(const char* cause) const {
  const auto& p = particles_;
  int worst = 0;
  double fastest = -1;
  for (std::size_t i = 0; i < p.size(); ++i) {
    // Not std::hypot: of (0, NaN, 0) libstdc++ 12 makes 0, and the culprit would not be named.
    const double speed = std::sqrt(p.vx[i] * p.vx[i] + p.vy[i] * p.vy[i] + p.vz[i] * p.vz[i]);
    if (speed <= fastest) continue;
    worst = static_cast<int>(i);
    fastest = speed;
    if (std::isnan(speed)) break;
  }
  throw Error(fmt::format(
      "blow-up at step {} (t = {:.6g} s), {}: particle {} at ({:.4g}, {:.4g}, {:.4g}) m moves at "
      "{:.3g} m/s under a force of {:.3g} N, largest overlap {:.3g} m; lower time.step_fraction or raise "
      "contact.youngs_modulus",
      step_, time(), cause, p.id[worst], p.x[worst], p.y[worst], p.z[worst], fastest,
      std::hypot(p.fx[worst], p.fy[worst], p.fz[worst]),
      std::max(pair_tally_.largest_overlap, wall_tally_.largest_overlap)));
}

}  // namespace clog
