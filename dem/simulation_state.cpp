// A run's state as bytes, and back; nothing that is read is trusted.

#include <cmath>

#include "coupling/archive.hpp"
#include "coupling/require.hpp"
#include "dem/simulation.hpp"

namespace clog {

namespace {

void demand(bool sound, const char* part) {
  require(sound, "a saved state is damaged ({})", part);
}

template <class... Numbers>
bool finite_from_zero(Numbers... numbers) {
  return (... && (std::isfinite(numbers) && numbers >= 0));
}

}  // namespace

std::string Simulation::save() {
  count_seconds();
  ArchiveWriter archive;
  exchange(archive);
  return archive.bytes();
}

void Simulation::resume(const std::string& state) {
  const std::string scene_text = data_.scene_text;
  const std::uint64_t seed = data_.seed;
  ArchiveReader archive(state);
  exchange(archive);
  require(archive.at_end(), "a saved state is longer than it should be");
  demand(data_.scene_text == scene_text && data_.seed == seed, "of another scene or seed");
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
  const auto& provenance = data_.provenance;
  demand(wrong.empty() && (provenance.is_object() || provenance.is_null()), wrong.empty() ? "provenance" : wrong.c_str());
  demand(!watch_.friction_off() || !data_.releases.on.empty(), "release");

  demand(finite_from_zero(drifted_, way_, margin_, drifted_when_sorted_, next_insertion_, next_porosity_, next_series_, next_snapshot_,
                          particle_steps_, seconds_, filling_.duration) &&
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

}  // namespace clog
