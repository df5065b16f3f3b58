#include "dem/run/recorder.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "coupling/base/quantile.hpp"
#include "dem/contact/contact_forces.hpp"
#include "dem/run/blow_up.hpp"
#include "dem/run/whole_step.hpp"
#include "dem/state/valid.hpp"

namespace clogflow {

namespace {

/// When something that is recorded at this interval is due next.
double next_due(const RunState& state, double interval) {
  const StepClock& clock = state.clock;
  if (!state.filling.is_done() || clock.step() == 0) return 0;
  // What look() compared with at its last call.
  const double looked = static_cast<double>(clock.step() - 1) * clock.dt() + clock.dt() / 2;
  if (interval <= clock.dt()) return looked;
  double next = 0;
  while (next <= looked) next += interval;
  return next;
}

struct Crossing {
  double since;  // time from the crossing to now [s]
  int particle;
};

/// Marks those beyond the plane. \return them in order of time
std::vector<Crossing> new_crossings(RunState& state) {
  Particles& p = state.particles;
  const double plane = state.model.domain.passage;
  std::vector<Crossing> crossings;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p[i].x < plane || p.passed[i]) continue;
    p.passed[i] = 1;
    crossings.push_back(
        {p[i].vx > 0 ? std::min((p[i].x - plane) / p[i].vx, state.clock.dt()) : 0, static_cast<int>(i)});
  }
  std::stable_sort(crossings.begin(), crossings.end(),
                   [](const Crossing& a, const Crossing& b) { return a.since > b.since; });
  return crossings;
}

/// By their numbers, each pair as the one with the lower number sees it: the same however the lists are sorted.
RunData::Contacts contacts_of(const RunState& state) {
  const Particles& p = state.particles;
  struct Row {
    std::int64_t a, b;
    Vec3 normal, force;
  };
  std::vector<Row> rows;
  for (const ContactForce& c :
       contact_forces(p, state.lists.pairs, state.lists.walls, state.present(state.model.laws.pair),
                      state.present(state.model.laws.wall.contact), state.clock.stretch_time())) {
    const std::int64_t own = p.id[c.particle], other = c.other < 0 ? -1 : p.id[c.other];
    const bool turned = other >= 0 && other < own;
    rows.push_back({turned ? other : own, turned ? own : other, turned ? Vec3(-c.normal) : c.normal,
                    turned ? Vec3(-c.force) : c.force});
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Row& x, const Row& y) { return std::pair(x.a, x.b) < std::pair(y.a, y.b); });
  RunData::Contacts contacts;
  const auto put = [](std::vector<float>& to, const Vec3& v) {
    for (const double value : {v.x, v.y, v.z}) to.push_back(static_cast<float>(value));
  };
  for (const Row& row : rows) {
    contacts.a.push_back(row.a);
    contacts.b.push_back(row.b);
    put(contacts.normal, row.normal);
    put(contacts.force, row.force);
  }
  return contacts;
}

}  // namespace

Recorder::Recorder(const Scene& scene, std::uint64_t seed)
    : bursts_(scene.output.burst_snapshots, scene.stokes_time()) {
  data.seed = seed;
  data.scene_text = effective_scene(scene);
  data.has_contacts = scene.output.contacts;
}

void Recorder::look(RunState& state) {
  const auto& output = state.model.scene.output;
  // Half a step of slack, so that a multiple of dt is not missed by rounding.
  const double now = state.time() + state.clock.dt() / 2;
  if (output.series_interval > 0 && now >= next_series_) {
    sample_series(state);
    next_series_ += output.series_interval;
  }
  const bool regular = state.clock.step() == 0 || (output.snapshot_interval > 0 && now >= next_snapshot_);
  const bool of_burst = bursts_.due(now);
  if ((regular || of_burst) && state.clock.step() < state.model.steps) snapshot(state);
  if (regular) next_snapshot_ += output.snapshot_interval;
  if (of_burst) bursts_.took();
}

void Recorder::sample_series(RunState& state) {
  const auto& p = state.particles;
  // The way of the last step over its duration: a pack that shakes does so between whole steps.
  std::vector<double> speeds(p.size());
  for (std::size_t i = 0; i < p.size(); ++i)
    speeds[i] = std::sqrt(p[i].vx * p[i].vx + p[i].vy * p[i].vy + p[i].vz * p[i].vz);
  const double kinetic = kinetic_energy(state), elastic = elastic_energy(state);
  if (!std::isfinite(kinetic + elastic)) blow_up(state, "an energy is no number", fastest_particle(state));
  auto& series = data.series;
  if (series.time.empty()) state.energy.brought = kinetic + elastic;
  series.time.push_back(state.time());
  series.count.push_back(static_cast<std::int64_t>(p.size()));
  series.porosity.push_back(state.fluid.strips().upstream_porosity());
  series.packing_fraction.push_back(state.fluid.strips().packing_fraction());
  series.kinetic_energy.push_back(kinetic);
  series.elastic_energy.push_back(elastic);
  series.largest_overlap.push_back(state.largest_overlap());
  series.contacts.push_back(state.pair_tally.contacts);
  series.wall_contacts.push_back(state.wall_tally.contacts);
  series.drag_work.push_back(state.energy.drag_work);
  series.dissipated.push_back(state.energy.supplied() - kinetic - elastic);
  series.median_speed.push_back(quantile(speeds, 0.5));
  series.speed_q99.push_back(quantile(speeds, 0.99));
  if (state.fluid.drive().on()) series.flow_factor.push_back(state.fluid.drive().factor());
  if (state.fluid.drive().balances()) series.pressure_drop.push_back(state.fluid.drive().pressure_drop());
}

void Recorder::snapshot(const RunState& state) {
  const auto& p = state.particles;
  std::vector<int> order(p.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = static_cast<int>(k);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return p.id[a] < p.id[b]; });
  RunData::Snapshot snapshot;
  snapshot.time = state.time();
  const auto put = [](std::vector<double>& to, const Vec3& v) { to.insert(to.end(), {v.x, v.y, v.z}); };
  for (int i : order) {
    snapshot.id.push_back(p.id[i]);
    snapshot.radius.push_back(p[i].radius);
    if (!state.model.sizes.equal()) snapshot.species.push_back(p.species[i]);
    put(snapshot.position, p[i].position());
    put(snapshot.velocity, velocity_now(state, i));
    put(snapshot.spin, spin_now(state, i));
    put(snapshot.force, total_force(state, i));
    put(snapshot.torque, {p[i].tx, p[i].ty, p[i].tz});
  }
  if (data.has_contacts) snapshot.contacts = contacts_of(state);
  data.snapshots.push_back(std::move(snapshot));
}

void Recorder::find_passages(RunState& state) {
  const Particles& p = state.particles;
  for (const auto& [since, i] : new_crossings(state)) {
    data.passages.time.push_back(state.time() - since);
    data.passages.id.push_back(p.id[i]);
    data.passages.y.push_back(p[i].y - since * p[i].vy);
    data.passages.z.push_back(p[i].z - since * p[i].vz);
    data.passages.friction_off.push_back(state.clog_watch.friction_off());
    if (!state.model.sizes.equal()) {
      data.passages.radius.push_back(p[i].radius);
      data.passages.species.push_back(p.species[i]);
    }
    state.clog_watch.passed(state.flow_time());
    bursts_.flows(state.time());
  }
}

void Recorder::pass_over(RunState& state) const { new_crossings(state); }

void Recorder::take_back(RunState& state) {
  Particles& p = state.particles;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (p[i].x < state.model.domain.passage - p[i].radius) p.passed[i] = 0;
}

void Recorder::stop(const RunState& state) {
  data.record.clogged_at = state.time();
  data.record.clog_proved = state.clog_watch.proved();
  data.record.clog_position = clog_state(state.particles, state.model.scene).position;
}

void Recorder::begin_release(const RunState& state) {
  const ClogState clog = clog_state(state.particles, state.model.scene);
  data.releases.off.push_back(state.time());
  data.releases.on.push_back(state.model.scene.time.end);
  data.releases.largest_speed.push_back(clog.largest_speed);
  data.releases.position.push_back(clog.position);
  bursts_.flows(state.time());
}

void Recorder::end_release(const RunState& state) {
  data.releases.on.back() = state.time();
  // The burst that counts begins now, in the midst of what the release set free.
  bursts_.restart();
  bursts_.flows(state.time());
}

void Recorder::change_series_interval(const RunState& state) {
  next_series_ = next_due(state, state.model.scene.output.series_interval);
}

void Recorder::change_snapshot_interval(const RunState& state) {
  next_snapshot_ = next_due(state, state.model.scene.output.snapshot_interval);
}

bool Recorder::has_valid_clocks() const { return finite_from_zero(next_series_, next_snapshot_) && bursts_.is_valid(); }

}  // namespace clogflow
