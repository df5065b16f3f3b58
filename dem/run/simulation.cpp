#include "dem/run/simulation.hpp"

#include "coupling/base/require.hpp"
#include "dem/run/blow_up.hpp"
#include "dem/run/coming_and_going.hpp"
#include "dem/run/forces.hpp"
#include "dem/run/initial_placement.hpp"
#include "dem/run/kept_column.hpp"
#include "dem/run/present_network.hpp"
#include "dem/run/rest_proof.hpp"
#include "dem/run/saved_state.hpp"
#include "dem/run/whole_step.hpp"

namespace clogflow {

namespace {

/// Steps between two calls of the watcher.
constexpr std::int64_t watch_every = 256;

}  // namespace

Simulation::Simulation(const Scene& scene, const FlowGrid* flow, std::uint64_t seed, int threads)
    : Simulation(scene, flow, seed, read_initial_particles(scene), threads) {
  check_placement(read_initial_file(scene), model_);
}

Simulation::Simulation(const Scene& scene, const FlowGrid* flow, std::uint64_t seed,
                       const std::vector<Particle>& initial, int threads)
    : model_(make_model(scene, flow, initial)),
      kernels_(select_kernels()),
      state_(model_, make_fluid(scene, flow), seed, initial, threads),
      recorder_(scene, seed) {
  if (flow) recorder_.data.record.flow_hash = flow->hash;
}

RunData Simulation::run(const Watcher& watcher) {
  state_.computing_time.start();
  recorder_.data.record.step_limits = stability_.announce(model_);
  fill(watcher);
  while (state_.clock.step() < model_.steps && !state_.ended()) {
    tell(watcher);
    compute_forces();
    record();
    if (state_.ended()) break;
    stability_.look(state_);
    advance();
  }
  recorder_.data.end_state = SavedState(state_, recorder_).save_end();
  compute_forces();
  record();
  recorder_.snapshot(state_);
  finish();
  return std::move(recorder_.data);
}

void Simulation::fill(const Watcher& watcher) {
  if (!state_.filling.has_begun()) begin_filling();
  Filling& filling = state_.filling;
  while (!filling.is_done()) {
    tell(watcher);
    const std::int64_t before = state_.inlet.inserted();
    compute_forces();
    stability_.look(state_);
    advance();
    if (state_.inlet.inserted() != before) filling.fed(time());
    const auto slow_speed = [&] { return clog_state(particles(), model_.scene).quantile_speed; };
    if (filling.ends(time(), state_.gone(), slow_speed)) begin_run();
  }
}

void Simulation::begin_filling() {
  state_.filling.begin(time());
  if (state_.filling.is_done()) return;
  state_.inlet.scatter(state_.particles, state_.random);
  state_.place_walls();
}

void Simulation::begin_run() {
  stability_.say(state_.filling.note());
  state_.place_walls();
  state_.clock.restart();
  state_.next_insertion = state_.next_porosity = 0;
  state_.inlet.restart_clock();
  state_.fluid.drive().restart();
  state_.energy.restart();
  state_.clog_watch = ClogWatch(model_.scene);
  state_.supply_watch = SupplyWatch(model_.scene);
  state_.step_watch = {};
  // Those between the plane and the outlet passed before time 0.
  recorder_.pass_over(state_);
}

void Simulation::compute_forces() {
  go_back_or_keep(state_);
  feed_inlet(state_);
  if (state_.clog_watch.pokes() || !state_.lists.hold(particles()))
    state_.lists.rebuild(state_.particles, leaving_particles(state_), state_.team);
  state_.lists.sort_if_due(state_.particles, state_.team);
  if (time() >= state_.next_porosity) {
    state_.fluid.update_porosity(state_.particles);
    state_.next_porosity = time() + model_.scene.porosity.update_interval;
  }
  sum_contacts(state_, kernels_);
  meet_fluid(state_);
  if (account_) account_->look(state_);
}

void Simulation::record() {
  const double now = state_.flow_time();
  const auto clog = [&] {
    ClogState near = clog_state(particles(), model_.scene);
    near.quantile_speed = state_.fluid.drive().in_mean_flow(near.quantile_speed);
    return near;
  };
  const auto proved = [&] { return rests_for_good(state_); };
  using Action = ClogWatch::Action;
  const Action action = state_.clog_watch.act(now, state_.gone(), clog, proved);
  if (action == Action::friction_off || action == Action::poke) recorder_.begin_release(state_);
  if (action == Action::friction_on || action == Action::poke) recorder_.end_release(state_);
  if (action == Action::stop) recorder_.stop(state_);
  state_.column.weigh(state_);
  const auto packing = [&] { return 1 - state_.fluid.strips().upstream_porosity().back(); };
  if (state_.supply_watch.drains(now, packing)) recorder_.drained(state_);
  recorder_.look(state_);
}

void Simulation::advance() {
  stability_.check_overlap(state_);
  const AdvanceTally tally = advance_all(state_, kernels_);
  if (state_.count() > 0 && !(tally.largest_speed < too_fast(state_)))
    blow_up(state_, "thrown", fastest_particle(state_));
  state_.loads_are_clear = true;
  state_.energy.drag_work += tally.drag_work;
  state_.energy.body_work += tally.body_work;
  state_.particle_steps += static_cast<double>(state_.count());
  state_.fluid.drive().advance(state_.clock.dt());
  state_.clock.advance();
  if (state_.fluid.drive().reverses()) recorder_.take_back(state_);
  // Particles that were put beyond the plane, or are numbered anew, come with new lists.
  if (state_.filling.is_done() && (tally.crossed || state_.lists.renumbered())) recorder_.find_passages(state_);
  state_.lists.moved(tally.largest_speed * state_.clock.dt());
}

void Simulation::tell(const Watcher& watcher) const {
  const bool hurried = hurry_ && hurry_->load(std::memory_order_relaxed);
  if (watcher && (hurried || state_.clock.step() % watch_every == 0)) watcher(progress_of(state_, data()));
}

void Simulation::change_step(double dt) {
  require(dt > 0, "a step of {} s", dt);
  state_.clock.change_step(dt);
  state_.next_porosity = 0;
  recorder_.restart();
}

NetworkLimit Simulation::network() const { return present_network(state_); }

double Simulation::elastic_energy() const { return clogflow::elastic_energy(state_); }

double Simulation::kinetic_energy() const { return clogflow::kinetic_energy(state_); }

std::string Simulation::save() { return SavedState(state_, recorder_).save(); }

void Simulation::resume(const std::string& state) { SavedState(state_, recorder_).resume(state); }

void Simulation::lengthen(RunData done, const std::string& end_state) {
  SavedState(state_, recorder_).lengthen(std::move(done), end_state);
}

}  // namespace clogflow
