// When is the neck clogged, and what the scene's protocol then does.
#pragma once

#include <cstdint>

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

/// A clog is known in one of two ways: it is proved to be at rest for good (dem/run/rest_proof.hpp), or nothing has
/// passed for `unclog.after` and the slow majority near the neck is at rest. Then, by unclog.protocol,
///   none     nothing
///   stop     the run ends; a clog that was not proved must have been at rest for four times as long
///   release  friction is off for `unclog.duration`: the protocol of silo experiments
///   restart  friction is off until `unclog.strain` has passed, as before a flowing start
///   rewind   the same, but the column is first put back to where friction began last (dem/run/kept_column.hpp)
///   poke     the arch is taken out
/// A clog that never comes to rest is left to the statistics as a censored arrest.
class ClogWatch {
public:
  explicit ClogWatch(const Scene& scene);

  /// A particle crossed the passage plane at time t.
  void passed(double time) { last_event_ = time; }

  enum class Action { none, friction_off, friction_on, poke, stop };

  /// What to do at time t. \param gone  particles that ever left the channel
  /// \param state, proved  what clog_state() and rests_for_good() say; called only when the answer depends on it
  template <class State, class Proved>
  Action act(double time, std::int64_t gone, State&& state, Proved&& proved) {
    if (protocol_ == UnclogProtocol::none || stopped_) return Action::none;
    if (friction_off_) return flows_enough(time, gone) ? end_flow(time) : Action::none;
    if (time < last_event_ + (shortcut_ ? least_wait_ : longest_wait()) || time < next_look_) return Action::none;
    next_look_ = time + look_interval_;
    proved_ = shortcut_ && proved();
    if (!proved_ && (time < last_event_ + longest_wait() || state().quantile_speed > rest_speed_)) return Action::none;
    return begin(time, gone);
  }

  bool friction_off() const { return friction_off_; }
  bool stopped() const { return stopped_; }  ///< the run ends here
  bool proved() const { return proved_; }    ///< the last clog was at rest for good

  /// Whether an arch is to be taken out before the next forces.
  bool pokes() const { return pokes_; }
  void poked(std::int64_t particles) { pokes_ = false, taken_out_ += particles; }
  std::int64_t taken_out() const { return taken_out_; }  ///< particles, of all arches

  /// Whether the column is to be kept, or put back, before the next forces: friction has begun, or the clog is there.
  bool keeps() const { return keeps_; }
  bool goes_back() const { return goes_back_; }
  void kept() { keeps_ = false; }
  /// \param gone  particles that ever left, as it is now
  void went_back(std::int64_t gone) { goes_back_ = false, gone_when_off_ = gone; }

  /// Below this speed a particle counts as at rest [m/s]
  double rest_speed() const { return rest_speed_; }

  template <class Archive>
  void exchange(Archive& archive) {
    archive(last_event_, next_look_, off_since_, gone_when_off_, friction_off_, stopped_, proved_, pokes_, taken_out_);
    if (rewinds()) archive(keeps_, goes_back_);
  }

private:
  bool rewinds() const { return protocol_ == UnclogProtocol::rewind; }
  bool flows_enough(double time, std::int64_t gone) const;
  Action end_flow(double time);
  Action begin(double time, std::int64_t gone);
  double longest_wait() const;

  UnclogProtocol protocol_;
  bool shortcut_;
  double after_, duration_, look_interval_, rest_speed_, least_wait_;
  std::int64_t enough_ = 0;  // particles of a restart
  double last_event_ = 0, next_look_ = 0, off_since_ = 0;
  std::int64_t gone_when_off_ = 0, taken_out_ = 0;
  bool friction_off_ = false, stopped_ = false, proved_ = false, pokes_ = false, goes_back_ = false;
  bool keeps_;
};

/// Speed below which a particle counts as at rest: a thousandth of the scene's speed_scale() [m/s].
double rest_speed(const Scene& scene);

/// Between two looks at the column [s].
double look_interval(const Scene& scene);

}  // namespace clogflow
