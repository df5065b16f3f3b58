#include "dem/run/saved_state.hpp"

#include <utility>

#include "coupling/base/archive.hpp"
#include "coupling/base/require.hpp"
#include "coupling/scene/scene_difference.hpp"
#include "dem/run/checkpoint.hpp"

namespace clogflow {

namespace {

void demand(bool holds, const char* part) { require(holds, "a saved state is damaged ({})", part); }

/// A record without entries.
RunData nothing_of(const RunData& run) {
  RunData empty;
  empty.seed = run.seed;
  empty.scene_text = run.scene_text;
  empty.has_contacts = run.has_contacts;
  return empty;
}

}  // namespace

std::string SavedState::save() {
  state_.computing_time.lap();
  ArchiveWriter archive;
  exchange(archive);
  return archive.bytes();
}

void SavedState::resume(const std::string& bytes) {
  RunData recorded = nothing_of(recorder_.data);
  ArchiveReader archive(bytes);
  exchange(archive);
  require(archive.at_end(), "a saved state is longer than it should be");
  std::swap(recorded, recorder_.data);
  take_up(std::move(recorded));
}

std::string SavedState::save_end() {
  RunRows rows = rows_of(recorder_.data);
  RunData all = std::exchange(recorder_.data, nothing_of(recorder_.data));
  state_.computing_time.lap();
  ArchiveWriter archive;
  archive(rows);
  exchange(archive);
  recorder_.data = std::move(all);
  return archive.bytes();
}

void SavedState::lengthen(RunData done, const std::string& bytes) {
  RunData own = nothing_of(recorder_.data);
  ArchiveReader archive(bytes);
  RunRows rows;
  archive(rows);
  exchange(archive);
  require(archive.at_end(), "a saved state is longer than it should be");
  demand(cut_rows(done, rows), "not of what its run recorded");
  recorder_.data = std::move(own);
  take_up(std::move(done));
}

/// Fits what was read to our scene.
void SavedState::take_up(RunData recorded) {
  RunData& data = recorder_.data;
  const auto differences = scene_differences(recorded.scene_text, data.scene_text);
  demand(!find_role(differences, KeyRole::trajectory) && data.seed == recorded.seed, "of another scene or seed");
  for (const SceneDifference& each : differences) {
    if (each.key == "output.series_interval") recorder_.change_series_interval(state_);
    if (each.key == "output.snapshot_interval") recorder_.change_snapshot_interval(state_);
  }
  recorded.scene_text = std::move(data.scene_text);
  data = std::move(recorded);
  const double end = state_.model.scene.time.end;
  if (state_.clog_watch.friction_off() && !data.releases.on.empty()) data.releases.on.back() = end;
  if (state_.filling.is_done() && state_.clock.step() > state_.model.steps)
    throw StateRefused(
        fmt::format("is at t = {:.6g} s, beyond time.end = {:.6g} s: raise time.end", state_.time(), end));
  check();
}

void SavedState::check() const {
  const RunData& data = recorder_.data;
  if (const char* part = state_.damaged_part()) demand(false, part);
  const std::string wrong = fault(data);
  demand(wrong.empty(), wrong.c_str());
  demand(!state_.clog_watch.friction_off() || !data.releases.on.empty(), "release");
  demand(recorder_.has_valid_clocks(), "clocks or energies");
}

}  // namespace clogflow
