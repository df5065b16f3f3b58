// A filled start: the pack settles against a gate across the neck, is tapped, settles again ... until the gate opens.
#pragma once

#include <cstdint>

#include "coupling/scene/scene.hpp"

namespace clogflow {

/// Each tap, a while without friction, lets the pack close its loosest arches; the channel then fills up again.
class Filling {
public:
  explicit Filling(const Scene& scene) : scene_(&scene) {}

  bool has_begun() const { return stage_ != Stage::before; }
  bool is_done() const { return stage_ == Stage::done; }
  bool is_tapping() const { return stage_ == Stage::tap; }
  bool gate_is_closed() const { return stage_ == Stage::settle || stage_ == Stage::tap; }

  /// Whether the scene starts with a filled channel.
  bool is_wanted() const { return scene_->inlet.enabled && scene_->inlet.start == InletStart::filled; }

  /// Closes the gate; or is done at once, if no filling is wanted.
  void begin(double time);

  /// The inlet put particles in during the step that ended at `time`.
  void fed(double time) { last_insertion_ = time; }

  enum class Gate { stays_closed, opens };

  /// Goes on to the next stage when this one is over.
  /// \param slow_speed  gives the speed of the slow majority near the neck; called only where the answer depends on it
  template <class SlowSpeed>
  Gate look(double time, const SlowSpeed& slow_speed) {
    if (stage_ == Stage::tap) {
      if (time >= stage_began_ + tap_time()) enter(Stage::settle, time);
      return Gate::stays_closed;
    }
    if (!settled(time, slow_speed)) return Gate::stays_closed;
    if (taps_++ < scene_->inlet.taps) {
      enter(Stage::tap, time);
      return Gate::stays_closed;
    }
    stage_ = Stage::done;
    duration_ = time;
    return Gate::opens;
  }

  double duration() const { return duration_; }          ///< of the whole filling [s]
  bool ended_at_rest() const { return ended_at_rest_; }  ///< not because it took too long

  /// Whether what was read from a saved state is a filling that stands at `time`.
  bool valid(double time) const;

  template <class Archive>
  void exchange(Archive& archive) {
    archive(stage_, taps_, stage_began_, last_insertion_, next_look_, duration_, ended_at_rest_);
  }

private:
  enum class Stage { before, settle, tap, done };

  void enter(Stage stage, double time);
  double tap_time() const;
  double longest_stage() const;
  double still_time() const;
  double look_interval() const;
  double rest_speed() const;

  template <class SlowSpeed>
  bool settled(double time, const SlowSpeed& slow_speed) {
    ended_at_rest_ = false;
    if (time > stage_began_ + longest_stage()) return true;
    if (time < next_look_) return false;
    next_look_ = time + look_interval();
    ended_at_rest_ = time - last_insertion_ > still_time() && slow_speed() < rest_speed();
    return ended_at_rest_;
  }

  const Scene* scene_;
  Stage stage_ = Stage::before;
  int taps_ = 0;                                                 // begun
  double stage_began_ = 0, last_insertion_ = 0, next_look_ = 0;  // [s]
  double duration_ = 0;                                          // [s]
  bool ended_at_rest_ = true;
};

}  // namespace clogflow
