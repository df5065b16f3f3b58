#include "dem/run/filling.hpp"

#include <algorithm>

#include "dem/run/clog_watch.hpp"
#include "dem/state/valid.hpp"

namespace clogflow {

namespace {

/// The channel counts as full when nothing was inserted for this many tau and it is at rest.
constexpr double full_after = 1.0;

/// Filling takes about as long as the flow needs to pass the channel twice; beyond this many
/// passages it will not come to rest at all.
constexpr double longest_fill = 10;

/// Friction is off for this many tau in a tap, as long as in a release of the paper's scene.
constexpr double tap_duration = 0.23;

/// Share of tau between two looks at the speeds.
constexpr double look_share = 0.1;

}  // namespace

void Filling::begin(double time) {
  if (is_wanted())
    enter(Stage::settle, time);
  else
    stage_ = Stage::done;
}

void Filling::enter(Stage stage, double time) {
  stage_ = stage;
  stage_began_ = last_insertion_ = time;
  next_look_ = time + still_time();
}

double Filling::tap_time() const { return tap_duration * scene_->stokes_time(); }

double Filling::still_time() const { return full_after * scene_->stokes_time(); }

double Filling::look_interval() const { return look_share * scene_->stokes_time(); }

double Filling::rest_speed() const { return clogflow::rest_speed(*scene_); }

double Filling::longest_stage() const {
  return std::max(100 * scene_->stokes_time(), longest_fill * scene_->geometry.channel_length / scene_->flow_speed());
}

bool Filling::valid(double time) const {
  if (!finite_from_zero(duration_)) return false;
  if (is_done()) return true;
  return is_wanted() && gate_is_closed() && taps_ >= 0 && taps_ <= scene_->inlet.taps &&
         finite_from_zero(stage_began_, last_insertion_, next_look_) && stage_began_ <= time;
}

}  // namespace clogflow
