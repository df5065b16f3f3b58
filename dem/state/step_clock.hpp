// Where a run stands in time: places at whole steps, velocities half a step before them.
#pragma once

#include <cstdint>

namespace clogflow {

/// Time of the leapfrog. Particles begin with the velocities of time 0, not of half a step before: so the first kick is
/// half as long as all others, and nothing has moved before it.
class StepClock {
public:
  explicit StepClock(double dt) : dt_(dt) {}

  double dt() const { return dt_; }  ///< [s]
  std::int64_t step() const { return step_; }
  double time() const { return static_cast<double>(step_) * dt_; }  ///< of the places [s]

  /// Duration of the kick that comes next [s].
  double kick() const { return has_moved_ ? dt_ : dt_ / 2; }

  /// From the time of the velocities to that of the places [s].
  double lag() const { return has_moved_ ? dt_ / 2 : 0; }

  /// In which springs grow to where they are now: what has not moved stretches none [s].
  double stretch_time() const { return has_moved_ ? dt_ : 0; }

  void advance() {
    has_moved_ = true;
    ++step_;
  }

  /// The same motion, its time counted from 0.
  void restart() { step_ = 0; }

  /// Goes on from time 0 with another step.
  void change_step(double dt) {
    dt_ = dt;
    step_ = 0;
  }

  template <class Archive>
  void exchange(Archive& archive) {
    archive(step_, has_moved_);
  }

private:
  double dt_;
  std::int64_t step_ = 0;
  bool has_moved_ = false;
};

}  // namespace clogflow
