// What a run writes down while it goes: time series, snapshots, releases, passages.
#pragma once

#include <cstdint>
#include <string>

#include "coupling/files/run_file.hpp"
#include "dem/protocol/burst_clock.hpp"
#include "dem/run/run_state.hpp"

namespace clogflow {

class Recorder {
public:
  Recorder(const Scene& scene, std::uint64_t seed);

  RunData data;

  /// Series and snapshots, if they are due; after the forces. \throws Error if an energy is no number
  void look(RunState& state);

  /// After the last step.
  void snapshot(const RunState& state);

  /// Those who passed in the step that was done last; the clog watch hears of it.
  void find_passages(RunState& state);

  /// Those who are beyond the plane already count no more.
  void pass_over(RunState& state) const;

  /// Where the flow goes back: those who are a radius before the plane again will count anew.
  static void take_back(RunState& state);

  /// The clog that ends the run.
  void stop(const RunState& state);

  /// The neck is no longer supplied, which ends it too.
  void drained(const RunState& state) { data.record.drained_at = state.time(); }

  void begin_release(const RunState& state);
  void end_release(const RunState& state);

  /// Times count from 0 again.
  void restart() {
    next_series_ = next_snapshot_ = 0;
    bursts_.restart();
  }

  /// Another interval than that of the run so far: goes on as if things had been recorded so from the start.
  void change_series_interval(const RunState& state);
  void change_snapshot_interval(const RunState& state);

  bool has_valid_clocks() const;

  template <class Archive>
  void exchange(Archive& archive) {
    archive(data, next_series_, next_snapshot_);
    if (bursts_.on()) archive(bursts_);
  }

private:
  void sample_series(RunState& state);

  double next_series_ = 0, next_snapshot_ = 0;  // when due [s]
  BurstClock bursts_;
};

}  // namespace clogflow
