#include "dem/run/kept_column.hpp"

#include "coupling/base/archive.hpp"
#include "dem/run/run_state.hpp"
#include "dem/run/whole_step.hpp"

namespace clogflow {

void KeptColumn::keep(RunState& state) {
  ArchiveWriter archive;
  archive(state.particles, state.lists);
  bytes_ = archive.bytes();
  is_weighed_ = false;
}

void KeptColumn::put_back(RunState& state) const {
  ArchiveReader archive(bytes_);
  archive(state.particles, state.lists);
  state.lists.pairs.measure(state.particles);
  require(archive.at_end() && state.particles.valid(state.model.largest_radius) && state.lists.valid(state.count()),
          "a saved state is damaged (kept column)");
  state.energy.brought += energy_ - energy_of_clog_;
  state.next_porosity = 0;
}

void KeptColumn::weigh(const RunState& state) {
  if (is_weighed_ && !state.clog_watch.goes_back()) return;
  (is_weighed_ ? energy_of_clog_ : energy_) = kinetic_energy(state) + elastic_energy(state);
  is_weighed_ = true;
}

void go_back_or_keep(RunState& state) {
  if (state.clog_watch.goes_back()) {
    state.column.put_back(state);
    state.clog_watch.went_back(state.gone());
  }
  if (state.clog_watch.keeps() && state.filling.is_done()) {
    state.column.keep(state);
    state.clog_watch.kept();
  }
}

}  // namespace clogflow
