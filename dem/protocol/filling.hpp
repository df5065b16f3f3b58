// What comes before time 0.
#pragma once

#include <cstdint>
#include <string>

#include "coupling/scene/scene.hpp"

namespace clogflow {

/// By inlet.start,
///   empty    nothing
///   filled   the pack settles against a gate across the neck, is tapped, settles again ... until the gate opens. Each
///            tap, a while without friction, lets the pack close its loosest arches; the channel then fills up again.
///            What stands behind the gate is jammed: the first that passes is what the opening shakes loose
///   flowing  the column flows without friction and without a gate until inlet.strain has passed; then friction begins
/// Each stage has a longest time, after which it is over all the same, and it is said.
class Filling {
public:
  explicit Filling(const Scene& scene) : scene_(&scene) {}

  bool has_begun() const { return stage_ != Stage::before; }
  bool is_done() const { return stage_ == Stage::done; }
  bool has_friction() const { return stage_ != Stage::tap && stage_ != Stage::flow; }
  bool gate_is_closed() const { return stage_ == Stage::settle || stage_ == Stage::tap; }

  /// Whether the scene starts with particles in the channel.
  bool is_wanted() const { return scene_->inlet.enabled && scene_->inlet.start != InletStart::empty; }

  /// Closes the gate, or lets the flow begin; or is done at once, if no filling is wanted.
  void begin(double time);

  /// The inlet put particles in during the step that ended at `time`.
  void fed(double time) { last_insertion_ = time; }

  /// Goes on to the next stage when this one is over. \return whether the run begins now
  /// \param gone        particles that ever left the channel
  /// \param slow_speed  gives the speed of the slow majority near the neck; called only where the answer depends on it
  template <class SlowSpeed>
  bool ends(double time, std::int64_t gone, const SlowSpeed& slow_speed) {
    if (stage_ == Stage::flow) return flowed(time, gone) && finish(time);
    if (stage_ == Stage::tap) {
      if (time >= stage_began_ + tap_time()) enter(Stage::settle, time);
      return false;
    }
    if (!settled(time, slow_speed)) return false;
    if (taps_++ >= scene_->inlet.taps) return finish(time);
    enter(Stage::tap, time);
    return false;
  }

  double duration() const { return duration_; }          ///< of the whole filling [s]
  bool ended_at_rest() const { return ended_at_rest_; }  ///< of a filled start: not because it took too long
  bool flowed() const { return flowed_; }                ///< of a flowing start: its strain, not its longest time
  /// What a user must know of how it ended, or empty.
  std::string note() const;

  /// Whether what was read from a saved state is a filling that stands at `time`.
  bool valid(double time) const;

  template <class Archive>
  void exchange(Archive& archive) {
    archive(stage_, taps_, stage_began_, last_insertion_, next_look_, duration_, ended_at_rest_, flowed_, gone_before_);
  }

private:
  enum class Stage { before, settle, tap, flow, done };

  void enter(Stage stage, double time);
  bool finish(double time);
  bool flowed(double time, std::int64_t gone);
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
  bool ended_at_rest_ = true, flowed_ = true;
  std::int64_t gone_before_ = -1;  // when the first had left; -1: none has
};

}  // namespace clogflow
