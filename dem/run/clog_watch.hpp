// When is the neck clogged, and what the release protocol then does.
#pragma once

#include "coupling/scene/scene.hpp"
#include "dem/state/particles.hpp"

namespace clogflow {

/// Speed of the slow majority near the neck, by which a clog is judged to be at rest.
struct ClogState {
  double quantile_speed;  ///< 90 % of the particles near the neck are slower [m/s]
  double largest_speed;   ///< near the neck [m/s]
  double position;        ///< x of the most downstream particle upstream of the passage plane [m]
};

/// Numbers of the particles within three neck widths upstream of the neck; of all upstream of the passage plane, if
/// none is there.
std::vector<int> near_neck(const Particles& particles, const Scene& scene);

/// Share of the particles near the neck that must be at rest for a clog to be: a few rattlers that the flow keeps
/// turning are left [-]
inline constexpr double slow_share = 0.9;

/// Of the particles near the neck, at the velocities half a step before their places.
ClogState clog_state(const Particles& particles, const Scene& scene);

/// The release protocol of silo experiments: when nothing has passed for `unclog.after` and the clog
/// is at rest, friction is switched off for `unclog.duration`. A single rattler does not count as
/// motion, which is why a quantile decides. A clog that never comes to rest is never released: it is
/// left to the statistics as a censored arrest.
class ClogWatch {
public:
  explicit ClogWatch(const Scene& scene);

  /// A particle crossed the passage plane at time t.
  void passed(double time) { last_event_ = time; }

  enum class Action { none, friction_off, friction_on };

  /// What to do at time t; `state` is called only when the answer depends on it.
  template <class State>
  Action act(double time, State&& state) {
    if (!enabled_) return Action::none;
    if (friction_off_) {
      if (time < off_since_ + duration_) return Action::none;
      friction_off_ = false;
      last_event_ = time;
      return Action::friction_on;
    }
    if (time < last_event_ + after_ || time < next_look_) return Action::none;
    next_look_ = time + look_interval_;
    if (state().quantile_speed > rest_speed_) return Action::none;
    friction_off_ = true;
    off_since_ = time;
    return Action::friction_off;
  }

  bool friction_off() const { return friction_off_; }

  /// Below this speed a particle counts as at rest [m/s]
  double rest_speed() const { return rest_speed_; }

  template <class Archive>
  void exchange(Archive& archive) {
    archive(last_event_, next_look_, off_since_, friction_off_);
  }

private:
  bool enabled_;
  double after_, duration_, look_interval_, rest_speed_;
  double last_event_ = 0, next_look_ = 0, off_since_ = 0;
  bool friction_off_ = false;
};

/// Speed below which a particle counts as at rest: a thousandth of the mean flow velocity [m/s].
double rest_speed(const Scene& scene);

}  // namespace clogflow
