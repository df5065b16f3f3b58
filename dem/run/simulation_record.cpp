// What a run writes down: time series, snapshots, releases, and at the end where it came from.

#include <algorithm>
#include <cmath>

#include <unistd.h>

#include "coupling/base/quantile.hpp"
#include "dem/run/simulation.hpp"

#ifndef CLOG_REVISION
#define CLOG_REVISION "unknown"
#endif

namespace clogflow {

Vector<double> Simulation::total_force(int i) const {
  const auto& p = particles_;
  const auto& body = model_.scene.body_force;
  const Vector<double> other{p[i].fx + body[0], p[i].fy + body[1], p[i].fz + body[2]};
  const Vector<double> velocity{p[i].vx, p[i].vy, p[i].vz};
  return other + (model_.scene.time.integrator == Integrator::verlet
                      ? fluid_.drag_force(i, velocity)
                      : fluid_.implicit_drag_force(i, velocity, other, next_kick() / p[i].mass));
}

Vector<double> Simulation::velocity_now(int i) const {
  const auto& p = particles_;
  const double half = kick_ == 0 ? 0 : model_.dt / 2;
  const Vector<double> velocity{p[i].vx, p[i].vy, p[i].vz};
  return velocity + half / p[i].mass * total_force(i);
}

Vector<double> Simulation::spin_now(int i) const {
  const auto& p = particles_;
  const double half = kick_ == 0 ? 0 : model_.dt / 2;
  const Vector<double> spin{p[i].wx, p[i].wy, p[i].wz};
  return spin + half / p[i].inertia * Vector<double>{p[i].tx, p[i].ty, p[i].tz};
}

void Simulation::record() {
  const Scene& s = model_.scene;
  const auto action = watch_.act(time(), [&] { return clog_state(particles_, s); });
  if (action == ClogWatch::Action::friction_off) {
    const ClogState state = clog_state(particles_, s);
    data_.releases.off.push_back(time());
    data_.releases.on.push_back(s.time.end);
    data_.releases.largest_speed.push_back(state.largest_speed);
    data_.releases.position.push_back(state.position);
    set_friction(false);
  } else if (action == ClogWatch::Action::friction_on) {
    data_.releases.on.back() = time();
    set_friction(true);
  }
  // Half a step of slack, so that a multiple of dt is not missed by rounding.
  const double now = time() + model_.dt / 2;
  if (s.output.series_interval > 0 && now >= next_series_) {
    sample_series();
    next_series_ += s.output.series_interval;
  }
  if (step_ == 0 || (s.output.snapshot_interval > 0 && now >= next_snapshot_)) {
    if (step_ < model_.steps) sample_snapshot();
    next_snapshot_ += s.output.snapshot_interval;
  }
}

double Simulation::elastic_energy() const {
  const auto& p = particles_;
  const Neighbours& n = neighbours_;
  double energy = walls_.empty() ? 0 : walls_.stored_energy(p, model_.laws.wall.contact);
  for (std::size_t k = 0; k < n.contacts.size(); ++k) {
    const int i = n.contacts.first(k), j = n.contacts.second(k);
    const PairPlace<double> place = pair_place(p, i, j);
    const double distance = place.distance();
    energy += model_.laws.pair.stored_energy(
        place.contact(distance, place.overlap(distance), reduced(p[i].mass, p[j].mass)), n.contacts.springs(k));
  }
  return energy;
}

void Simulation::sample_series() {
  const auto& p = particles_;
  // The way of the last step over its duration: a pack that shakes does so between whole steps.
  std::vector<double> speeds(p.size());
  for (std::size_t i = 0; i < p.size(); ++i)
    speeds[i] = std::sqrt(p[i].vx * p[i].vx + p[i].vy * p[i].vy + p[i].vz * p[i].vz);
  const double kinetic = kinetic_energy(), elastic = elastic_energy();
  if (!std::isfinite(kinetic + elastic)) blow_up("an energy is no number", fastest());
  if (data_.series.time.empty()) energy_in_ = kinetic + elastic;
  auto& series = data_.series;
  series.time.push_back(time());
  series.count.push_back(static_cast<std::int64_t>(p.size()));
  series.porosity.push_back(fluid_.strips().porosity());
  series.packing_fraction.push_back(fluid_.strips().packing_fraction());
  series.kinetic_energy.push_back(kinetic);
  series.elastic_energy.push_back(elastic);
  series.largest_overlap.push_back(largest_overlap());
  series.contacts.push_back(pair_tally_.contacts);
  series.wall_contacts.push_back(wall_tally_.contacts);
  series.drag_work.push_back(drag_work_);
  series.dissipated.push_back(drag_work_ + body_work_ + energy_in_ - kinetic - elastic);
  series.median_speed.push_back(quantile(speeds, 0.5));
  series.speed_q99.push_back(quantile(speeds, 0.99));
}

void Simulation::sample_snapshot() {
  const auto& p = particles_;
  std::vector<int> order(p.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = static_cast<int>(k);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return p.id[a] < p.id[b]; });
  RunData::Snapshot snapshot;
  snapshot.time = time();
  const auto put = [](std::vector<double>& to, const Vector<double>& v) { to.insert(to.end(), {v.x, v.y, v.z}); };
  for (int i : order) {
    snapshot.id.push_back(p.id[i]);
    snapshot.radius.push_back(p[i].radius);
    put(snapshot.position, {p[i].x, p[i].y, p[i].z});
    put(snapshot.velocity, velocity_now(i));
    put(snapshot.spin, spin_now(i));
    put(snapshot.force, total_force(i));
    put(snapshot.torque, {p[i].tx, p[i].ty, p[i].tz});
  }
  data_.snapshots.push_back(std::move(snapshot));
}

void Simulation::finish() {
  count_seconds();
  char host[256] = "unknown";
  gethostname(host, sizeof host - 1);
  RunRecord& r = data_.record;
  data_.end_time = time();
  r.program = "clogflow " CLOG_VERSION;
  r.revision = CLOG_REVISION;
  r.compiler = __VERSION__;
  r.instruction_set = kernels_.name;
  r.host = host;
  r.wall_time = seconds_;
  r.particle_steps = particle_steps_;
  r.particle_steps_per_s = seconds_ > 0 ? particle_steps_ / seconds_ : 0;
  r.time_step = model_.dt;
  r.contact_time = model_.contact_time;
  if (std::isfinite(step_watch_.smallest_limit)) r.contact_limit = step_watch_.smallest_limit;
  r.shaking_speed = step_watch_.shaking;
  r.fill_time = filling_.duration;
  r.fill_at_rest = filling_.at_rest;
  r.inserted = inlet_.inserted();
  r.insertions_refused = inlet_.refused();
  if (say_ && inlet_.shut())
    say_(fmt::format("the inlet found no room for any particle in {} attempts: the channel is full up to it",
                     inlet_.refused()));
  const std::int64_t left = given_ + inlet_.inserted() - static_cast<std::int64_t>(particles_.size());
  if (say_ && left > 0 && data_.passages.time.empty())
    say_(fmt::format(
        "warning: {} particle{} left at the outlet, x = {:.4g} m, and none was counted at passages.plane = {:.4g} m",
        left, left > 1 ? "s" : "", model_.domain.outlet, model_.domain.passage));
  if (model_.scene.contact.torsion_update == TorsionUpdate::doubling)
    r.experiment = "contact.torsion_update = \"doubling\": springs advanced wrongly on purpose";
}

}  // namespace clogflow
