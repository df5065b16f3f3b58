// A run's state as bytes, and back; nothing that is read is trusted.

#include <cmath>
#include <utility>

#include "coupling/base/archive.hpp"
#include "coupling/base/require.hpp"
#include "coupling/scene/scene_difference.hpp"
#include "dem/run/checkpoint.hpp"
#include "dem/run/simulation.hpp"

namespace clogflow {

namespace {

void demand(bool sound, const char* part) { require(sound, "a saved state is damaged ({})", part); }

template <class... Numbers>
bool finite_from_zero(Numbers... numbers) {
  return (... && (std::isfinite(numbers) && numbers >= 0));
}

/// A record without entries.
RunData nothing_of(const RunData& run) {
  RunData empty;
  empty.seed = run.seed;
  empty.scene_text = run.scene_text;
  return empty;
}

}  // namespace

std::string Simulation::save() {
  count_seconds();
  ArchiveWriter archive;
  exchange(archive);
  return archive.bytes();
}

void Simulation::resume(const std::string& state) {
  RunData recorded = nothing_of(data_);
  ArchiveReader archive(state);
  exchange(archive);
  require(archive.at_end(), "a saved state is longer than it should be");
  std::swap(recorded, data_);
  take_up(std::move(recorded));
}

std::string Simulation::save_end() {
  RunRows rows = rows_of(data_);
  RunData all = std::exchange(data_, nothing_of(data_));
  count_seconds();
  ArchiveWriter archive;
  archive(rows);
  exchange(archive);
  data_ = std::move(all);
  return archive.bytes();
}

void Simulation::lengthen(RunData done, const std::string& end_state) {
  RunData own = nothing_of(data_);
  ArchiveReader archive(end_state);
  RunRows rows;
  archive(rows);
  exchange(archive);
  require(archive.at_end(), "a saved state is longer than it should be");
  demand(cut_rows(done, rows), "not of what its run recorded");
  data_ = std::move(own);
  take_up(std::move(done));
}

double Simulation::next_due(double interval) const {
  if (filling_.stage != Filling::Stage::done || step_ == 0) return 0;
  // What record() compared with at its last call.
  const double looked = static_cast<double>(step_ - 1) * model_.dt + model_.dt / 2;
  if (interval <= model_.dt) return looked;
  double next = 0;
  while (next <= looked) next += interval;
  return next;
}

void Simulation::take_up(RunData recorded) {
  const auto differences = scene_differences(recorded.scene_text, data_.scene_text);
  demand(!find_role(differences, KeyRole::trajectory) && data_.seed == recorded.seed, "of another scene or seed");
  const auto& output = model_.scene.output;
  for (const SceneDifference& each : differences) {
    if (each.key == "output.series_interval") next_series_ = next_due(output.series_interval);
    if (each.key == "output.snapshot_interval") next_snapshot_ = next_due(output.snapshot_interval);
  }
  recorded.scene_text = std::move(data_.scene_text);
  data_ = std::move(recorded);
  if (watch_.friction_off() && !data_.releases.on.empty()) data_.releases.on.back() = model_.scene.time.end;
  if (filling_.stage == Filling::Stage::done && step_ > model_.steps)
    throw StateRefused(
        fmt::format("is at t = {:.6g} s, beyond time.end = {:.6g} s: raise time.end", time(), model_.scene.time.end));
  check_resumed();
}

void Simulation::check_resumed() const {
  demand(particles_.sound(largest_radius_), "particles");
  demand(neighbours_.sound(particles_.size()), "pair list");
  demand(walls_.sound(particles_.size()), "wall contacts");
  demand(fluid_.strips().sound(), "porosity");
  demand(fluid_.noise().sound(), "random factors on the flow");
  demand(inlet_.sound(), "inlet");
  const std::string wrong = fault(data_);
  demand(wrong.empty(), wrong.c_str());
  demand(!watch_.friction_off() || !data_.releases.on.empty(), "release");

  demand(finite_from_zero(drifted_, way_, margin_, drifted_when_sorted_, next_insertion_, next_porosity_, next_series_,
                          next_snapshot_, particle_steps_, seconds_, filling_.duration) &&
             std::isfinite(drag_work_) && std::isfinite(body_work_) && std::isfinite(energy_in_) &&
             (kick_ == 0 || kick_ == model_.dt || kick_ == model_.dt / 2),
         "clocks or energies");
  // The end of a run and of a filling are bounds on the step; without them it would never end.
  constexpr std::int64_t most_steps = std::int64_t{1} << 53;
  const bool fills = inlet_.enabled() && model_.scene.inlet.start == InletStart::filled;
  if (filling_.stage == Filling::Stage::done) {
    demand(!gate_closed_ && step_ >= 0 && step_ <= model_.steps, "step");
  } else {
    demand(fills && (filling_.stage == Filling::Stage::settle || filling_.stage == Filling::Stage::tap) &&
               gate_closed_ && step_ >= 0 && step_ < most_steps && filling_.taps >= 0 &&
               filling_.taps <= model_.scene.inlet.taps &&
               finite_from_zero(filling_.stage_began, filling_.last_insertion, filling_.next_look) &&
               filling_.stage_began <= time(),
           "filling");
  }
}

}  // namespace clogflow
