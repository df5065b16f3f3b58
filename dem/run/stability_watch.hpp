// How near a run is to its largest stable step, and whether it has begun to blow up.
#pragma once

#include <string>

#include "dem/run/progress.hpp"
#include "dem/run/run_state.hpp"

namespace clogflow {

/// Tells a person of the step's limits before a run and of what comes near them; ends a run that blows up. What it
/// remembers is RunState::step_watch, so a run that is resumed says nothing twice.
class StabilityWatch {
public:
  void tell(Say say) { say_ = std::move(say); }
  void say(const std::string& line) const {
    if (say_ && !line.empty()) say_(line);
  }

  /// Before the run. \return one line on the limits \throws Error if the step is too large
  std::string announce(const Model& model) const;

  /// After the forces of a step, now and then: the limit of the contacts, shaking, and energy from nothing.
  /// \throws Error if the run begins above the limit, or if energy appears
  void look(RunState& state) const;

  /// Warns of deep contacts. \throws Error if they are pressed too deep
  void check_overlap(RunState& state) const;

private:
  void look_at_limit(RunState& state) const;
  void look_for_shaking(RunState& state) const;

  Say say_;
};

}  // namespace clogflow
