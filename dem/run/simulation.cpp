#include "dem/run/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "coupling/base/quantile.hpp"
#include "coupling/base/require.hpp"
#include "dem/run/initial_placement.hpp"

namespace clogflow {

namespace {

/// The channel counts as full when nothing was inserted for this many tau and it is at rest.
constexpr double full_after = 1.0;

/// Filling takes about as long as the flow needs to pass the channel twice; beyond this many
/// passages it will not come to rest at all.
constexpr double longest_fill = 10;

/// Friction is off for this many tau in a tap, as long as in a release of the paper's scene.
constexpr double tap_duration = 0.23;

/// A particle that moves farther than this share of its radius in one step has been thrown.
constexpr double longest_way = 0.5;

/// Steps for which a sorting of the candidates holds if the fastest particle keeps its speed: rarer
/// sorting means more candidates to watch.
constexpr double sorted_steps = 32;

/// Steps between two calls of the watcher.
constexpr std::int64_t watch_every = 256;

}  // namespace

Simulation::Simulation(const Scene& scene, const FlowGrid* flow, std::uint64_t seed)
    : Simulation(scene, flow, seed, read_initial_particles(scene)) {
  check_placement(read_initial_file(scene), model_);
}

Simulation::Simulation(const Scene& scene, const FlowGrid* flow, std::uint64_t seed,
                       const std::vector<Particle>& initial)
    : model_(make_model(scene, flow, initial)),
      fluid_(make_fluid(scene, flow)),
      kernels_(select_kernels()),
      random_(seed),
      inlet_(model_),
      watch_(scene),
      pair_law_(model_.laws.pair),
      wall_law_(model_.laws.wall.contact) {
  std::int64_t id = 0;
  for (const Particle& given : initial) {
    Particle particle = model_.particle(given.radius);
    particle.id = id++;
    particle.x = given.x, particle.y = given.y, particle.z = given.z;
    particle.vx = given.vx, particle.vy = given.vy, particle.vz = given.vz;
    particle.wx = given.wx, particle.wy = given.wy, particle.wz = given.wz;
    particles_.add(particle);
  }
  given_ = id;
  inlet_.number_from(id);
  largest_radius_ = scene.inlet.enabled ? scene.particles.diameter / 2 : 0;
  for (const ParticleState& p : particles_.states) largest_radius_ = std::max(largest_radius_, p.radius);
  walls_ = WallContacts(model_.walls, largest_radius_, model_.reach, model_.weld);
  data_.seed = seed;
  data_.scene_text = effective_scene(scene);
  if (flow) data_.record.flow_hash = flow->hash;
}

RunData Simulation::run(const Watcher& watcher) {
  clock_ = Clock::now();
  announce_step();
  fill(watcher);
  while (step_ < model_.steps) {
    if (watcher && is_watched())
      watcher({time(), model_.scene.time.end, step_, particle_steps_, particles_.size(), data_.passages.time.size(),
               data_.passages.time.empty() || time() - data_.passages.time.back() > model_.scene.stokes_time() / 2,
               false});
    compute_forces();
    record();
    watch_step();
    advance();
  }
  data_.end_state = save_end();
  compute_forces();
  record();
  sample_snapshot();
  finish();
  return std::move(data_);
}

bool Simulation::is_watched() const {
  return step_ % watch_every == 0 || (hurry_ && hurry_->load(std::memory_order_relaxed));
}

void Simulation::fill(const Watcher& watcher) {
  if (filling_.stage == Filling::Stage::before) begin_filling();
  const double tap_time = tap_duration * model_.scene.stokes_time();
  while (filling_.stage != Filling::Stage::done) {
    if (watcher && is_watched())
      watcher({-time(), model_.scene.time.end, step_, particle_steps_, particles_.size(), 0, false, true});
    const std::int64_t before = inlet_.inserted();
    compute_forces();
    watch_step();
    advance();
    if (inlet_.inserted() != before) filling_.last_insertion = time();
    if (filling_.stage == Filling::Stage::tap && time() >= filling_.stage_began + tap_time) {
      set_friction(true);
      enter_filling(Filling::Stage::settle);
    } else if (filling_.stage == Filling::Stage::settle && settled()) {
      // Each tap lets the pack close its loosest arches; the channel then fills up again.
      if (filling_.taps++ < model_.scene.inlet.taps) {
        set_friction(false);
        enter_filling(Filling::Stage::tap);
      } else {
        open_gate();
      }
    }
  }
}

void Simulation::begin_filling() {
  if (!inlet_.enabled() || model_.scene.inlet.start != InletStart::filled) {
    filling_.stage = Filling::Stage::done;
    return;
  }
  inlet_.scatter(particles_, random_);
  set_walls(true);
  enter_filling(Filling::Stage::settle);
}

void Simulation::enter_filling(Filling::Stage stage) {
  filling_.stage = stage;
  filling_.stage_began = filling_.last_insertion = time();
  filling_.next_look = time() + full_after * model_.scene.stokes_time();
}

bool Simulation::settled() {
  const Scene& s = model_.scene;
  const double tau = s.stokes_time();
  const double bound = std::max(100 * tau, longest_fill * s.geometry.channel_length / s.flow_speed());
  filling_.at_rest = false;
  if (time() > filling_.stage_began + bound) return true;
  if (time() < filling_.next_look) return false;
  filling_.next_look = time() + 0.1 * tau;
  filling_.at_rest = time() - filling_.last_insertion > full_after * tau &&
                     clog_state(particles_, s).quantile_speed < watch_.rest_speed();
  return filling_.at_rest;
}

void Simulation::open_gate() {
  filling_.stage = Filling::Stage::done;
  filling_.duration = time();
  set_walls(false);
  step_ = 0;
  next_insertion_ = next_porosity_ = 0;
  inlet_.restart_clock();
  drag_work_ = body_work_ = 0;
  watch_ = ClogWatch(model_.scene);
  step_watch_ = {};
}

void Simulation::set_walls(bool gate_closed) {
  gate_closed_ = gate_closed;
  Walls walls = model_.walls;
  if (gate_closed) walls.insert(walls.end(), model_.gate.begin(), model_.gate.end());
  walls_.change(walls, largest_radius_, particles_);
  lists_stale_ = true;
}

void Simulation::count_seconds() {
  const std::chrono::duration<double> since = Clock::now() - clock_;
  seconds_ += since.count();
  clock_ = Clock::now();
}

void Simulation::compute_forces() {
  if (inlet_.enabled() && time() >= next_insertion_) feed_inlet(time());
  // Two particles may approach each other by twice the way of one.
  if (lists_stale_ || 2 * drifted_ > model_.reach.skin) rebuild_lists();
  if (2 * (drifted_ - drifted_when_sorted_) >= margin_) sort_candidates();
  if (time() >= next_porosity_) {
    fluid_.update_porosity(particles_);
    next_porosity_ = time() + model_.scene.porosity.update_interval;
  }
  // At the very first evaluation nothing has moved yet, so no spring may grow.
  const double dt = kick_ == 0 ? 0 : model_.dt;
  Neighbours& n = neighbours_;
  const ParticlePointers p = pointers(particles_);
  WallLaws laws = model_.laws.wall;
  laws.contact = wall_law_;
  laws.dt = dt;
  const bool implicit_films = model_.scene.time.integrator == Integrator::implicit_fluid;
  const LubricationLaw film = implicit_films ? LubricationLaw{} : model_.laws.film;
  if (implicit_films) laws.lubrication = {};
  if (loads_used_) particles_.clear_loads();
  loads_used_ = true;
  pair_tally_ = kernels_.collide_pairs({p, n.contacts.pointers(), pair_law_, film, dt, n.equal_radius, n.equal_mass},
                                       model_.laws.pair_terms);
  wall_tally_ = walls_.collide_planes(particles_, kernels_, laws);
  const ContactTally corners = walls_.collide_corners(particles_, laws);
  wall_tally_.contacts += corners.contacts;
  wall_tally_.largest_overlap = std::max(wall_tally_.largest_overlap, corners.largest_overlap);
  // The channel is filled and comes to rest in the mean flow.
  if (!gate_closed_) fluid_.fluctuate(particles_, data_.seed, time());
  fluid_.evaluate(particles_);
  if (implicit_films) add_implicit_films(advance_task(), films());
}

AdvanceTask Simulation::advance_task() {
  const Scene& s = model_.scene;
  AdvanceTask task{};
  task.particles = pointers(particles_);
  fluid_.attach(task);
  for (int a = 0; a < 3; ++a) task.body_force[a] = s.body_force[a];
  task.kick = next_kick();
  task.drift = model_.dt;
  task.mass = neighbours_.equal_mass, task.inertia = neighbours_.equal_inertia;
  task.implicit_drag = s.time.integrator != Integrator::verlet;
  task.passage = model_.domain.passage;
  task.thrown = longest_way * neighbours_.smallest_radius / model_.dt;
  return task;
}

void Simulation::advance() {
  check_overlap();
  const AdvanceTask task = advance_task();
  kick_ = task.kick;
  const AdvanceTally tally = kernels_.advance(task);
  if (particles_.size() > 0 && !(tally.largest_speed < task.thrown)) blow_up("thrown", fastest());
  loads_used_ = false;
  way_ = tally.largest_speed * model_.dt;
  drifted_ += way_;
  drag_work_ += tally.drag_work;
  body_work_ += tally.body_work;
  particle_steps_ += static_cast<double>(particles_.size());
  ++step_;
  // Particles that were put beyond the plane, or are numbered anew, come with new lists.
  if (filling_.stage == Filling::Stage::done && (tally.crossed || lists_are_new_)) find_passages();
  lists_are_new_ = false;
}

void Simulation::change_step(double dt) {
  require(dt > 0, "a step of {} s", dt);
  model_.dt = dt;
  kick_ = kick_ == 0 ? 0 : dt;
  step_ = 0;
  next_porosity_ = next_series_ = next_snapshot_ = 0;
}

void Simulation::feed_inlet(double time) {
  const std::size_t before = particles_.size();
  if (inlet_.insert(particles_, fluid_, random_, time) > 0) lists_stale_ = true;
  for (std::size_t i = before; i < particles_.size(); ++i) {
    const auto& p = particles_;
    energy_in_ += clogflow::kinetic_energy(p[i], {p[i].vx, p[i].vy, p[i].vz}, {p[i].wx, p[i].wy, p[i].wz});
  }
  next_insertion_ = time + inlet_.interval();
}

void Simulation::take_out() {
  Particles& p = particles_;
  const Domain& d = model_.domain;
  leaving_.assign(p.size(), 0);
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p[i].x > d.outlet) {
      leaving_[i] = 1;
      energy_in_ -= clogflow::kinetic_energy(p[i], {p[i].vx, p[i].vy, p[i].vz}, {p[i].wx, p[i].wy, p[i].wz});
      continue;
    }
    const Vec3 place(p[i].x, p[i].y, p[i].z);
    require((place.array() >= d.low.array()).all() && (place.array() <= d.high.array()).all(),
            "particle {} left the walls, which reach from ({:.4g}, {:.4g}, {:.4g}) to ({:.4g}, {:.4g}, {:.4g}) m, at "
            "({:.4g}, {:.4g}, "
            "{:.4g}) m, t = {:.6g} s: {}",
            p.id[i], d.low.x(), d.low.y(), d.low.z(), d.high.x(), d.high.y(), d.high.z(), p[i].x, p[i].y, p[i].z,
            time(), model_.walls_note.empty() ? remedy(p[i]) : "through an opening? " + model_.walls_note);
  }
}

void Simulation::rebuild_lists() {
  take_out();
  const std::vector<int> renumbered = neighbours_.rebuild(particles_, leaving_, model_.reach);
  if (!walls_.empty()) walls_.rebuild(particles_, renumbered);
  drifted_ = 0;
  lists_stale_ = false;
  lists_are_new_ = true;
  sort_candidates();
}

void Simulation::sort_candidates() {
  const double skin = model_.reach.skin;
  margin_ = std::clamp(2 * sorted_steps * way_, 1e-3 * skin, skin);
  drifted_when_sorted_ = drifted_;
  neighbours_.sort(particles_, margin_, model_.laws.film);
  if (!walls_.empty()) walls_.sort(particles_, margin_, model_.laws.wall.lubrication);
}

void Simulation::find_passages() {
  const Domain& d = model_.domain;
  Particles& p = particles_;
  struct Crossing {
    double since;  // time from the crossing to now [s]
    int particle;
  };
  std::vector<Crossing> crossings;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p[i].x < d.passage || p.passed[i]) continue;
    p.passed[i] = 1;
    crossings.push_back({p[i].vx > 0 ? std::min((p[i].x - d.passage) / p[i].vx, model_.dt) : 0, static_cast<int>(i)});
  }
  std::stable_sort(crossings.begin(), crossings.end(),
                   [](const Crossing& a, const Crossing& b) { return a.since > b.since; });
  for (const auto& [since, i] : crossings) {
    data_.passages.time.push_back(time() - since);
    data_.passages.id.push_back(p.id[i]);
    data_.passages.y.push_back(p[i].y - since * p[i].vy);
    data_.passages.z.push_back(p[i].z - since * p[i].vz);
    data_.passages.friction_off.push_back(watch_.friction_off());
    watch_.passed(time());
  }
}

void Simulation::set_friction(bool on) {
  pair_law_ = model_.laws.pair;
  wall_law_ = model_.laws.wall.contact;
  if (on) return;
  pair_law_.friction = wall_law_.friction = {};
}

}  // namespace clogflow
