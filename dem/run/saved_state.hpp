// A run as bytes, and back; nothing that is read is trusted.
#pragma once

#include <string>

#include "dem/run/recorder.hpp"
#include "dem/run/run_state.hpp"

namespace clogflow {

/// A run between two steps: what its next step depends on, and what it recorded.
class SavedState {
public:
  SavedState(RunState& state, Recorder& recorder) : state_(state), recorder_(recorder) {}

  /// With all that was recorded.
  std::string save();
  /// \throws Error if the bytes are no such state; StateRefused if the run they belong to is another
  void resume(const std::string& bytes);

  /// For RunData::end_state: without what was recorded, for that is in the run file, but for how much it was.
  std::string save_end();
  /// \param done  what the run file holds \throws as resume()
  void lengthen(RunData done, const std::string& bytes);

private:
  void take_up(RunData recorded);
  void check() const;

  template <class Archive>
  void exchange(Archive& archive) {
    archive(state_, recorder_);
    if (state_.fluid.drive().on()) archive(recorder_.data.series.flow_factor, recorder_.data.series.pressure_drop);
  }

  RunState& state_;
  Recorder& recorder_;
};

}  // namespace clogflow
