#include "dem/run/kept_column.hpp"

#include "coupling/base/archive.hpp"
#include "dem/run/run_state.hpp"
#include "dem/run/whole_step.hpp"

namespace clogflow {

namespace {

double energy_of(const RunState& state) { return kinetic_energy(state) + elastic_energy(state); }

}  // namespace

void KeptColumn::keep(RunState& state) {
  ArchiveWriter archive;
  archive(state.particles, state.lists);
  bytes_ = archive.bytes();
}

void KeptColumn::put_back(RunState& state) const {
  const double before = energy_of(state);
  ArchiveReader archive(bytes_);
  archive(state.particles, state.lists);
  state.lists.pairs.measure(state.particles);
  const char* damaged = archive.at_end() ? state.damaged_part() : "kept column";
  require(!damaged, "a saved state is damaged ({})", damaged);
  state.energy.brought += energy_of(state) - before;
  state.next_porosity = 0;
}

void go_back(RunState& state) {
  state.column.put_back(state);
  state.clog_watch.went_back(state.gone());
}

void keep_column(RunState& state) {
  state.column.keep(state);
  state.clog_watch.kept();
}

}  // namespace clogflow
