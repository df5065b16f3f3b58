#include "dem/protocol/filling.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "dem/protocol/clog_watch.hpp"
#include "dem/protocol/frictionless_flow.hpp"
#include "dem/state/valid.hpp"

namespace clogflow {

namespace {

/// The channel counts as full when nothing was inserted for this many tau and it is at rest.
constexpr double full_after = 1.0;

/// A pack that is full is at rest within a few tau, if it ever is; and the channel is full when the flow has passed
/// through it twice. A pack that shakes is let go then, which costs no more than it does to fill.
constexpr double longest_rest = 20, longest_fill = 2;

/// Friction is off for this many tau in a tap, as long as in a release of the paper's scene.
constexpr double tap_duration = 0.23;

}  // namespace

void Filling::begin(double time) {
  if (is_wanted())
    enter(scene_->inlet.start == InletStart::flowing ? Stage::flow : Stage::settle, time);
  else
    stage_ = Stage::done;
}

bool Filling::finish(double time) {
  stage_ = Stage::done;
  duration_ = time;
  return true;
}

bool Filling::flowed(double time, std::int64_t gone) {
  // What the channel began with is on its way to the neck until the first leaves.
  if (gone_before_ < 0 && gone > 0) gone_before_ = gone;
  flowed_ = gone_before_ >= 0 && gone - gone_before_ >= particles_of_strain(*scene_, scene_->inlet.strain);
  return flowed_ || time > longest_stage();
}

std::string Filling::note() const {
  if (!flowed_)
    return fmt::format(
        "the flowing start stood after {:.4g} s without friction, before inlet.strain = {} had passed: arches hold "
        "here without friction, and the run begins with one",
        duration_, scene_->inlet.strain);
  if (!ended_at_rest_)
    return fmt::format(
        "the pack behind the gate never came to rest in {:.4g} s of filling (90 % slower than {:.3g} m/s): the gate "
        "was opened all the same; a smaller step may help, or inlet.start = \"flowing\"",
        duration_, rest_speed());
  return {};
}

void Filling::enter(Stage stage, double time) {
  stage_ = stage;
  stage_began_ = last_insertion_ = time;
  next_look_ = time + still_time();
}

double Filling::tap_time() const { return tap_duration * scene_->stokes_time(); }

double Filling::still_time() const { return full_after * scene_->stokes_time(); }

double Filling::look_interval() const { return clogflow::look_interval(*scene_); }

double Filling::rest_speed() const { return clogflow::rest_speed(*scene_); }

double Filling::longest_stage() const {
  const double pass = scene_->geometry.channel_length / scene_->speed_scale();
  if (stage_ == Stage::flow) return 2 * pass + longest_flow(*scene_, scene_->inlet.strain);
  return longest_rest * scene_->stokes_time() + (taps_ == 0 ? longest_fill : 1) * pass;
}

bool Filling::valid(double time) const {
  if (!finite_from_zero(duration_)) return false;
  if (is_done()) return true;
  const bool flows = scene_->inlet.start == InletStart::flowing;
  return is_wanted() && (flows ? stage_ == Stage::flow : gate_is_closed()) && taps_ >= 0 &&
         taps_ <= scene_->inlet.taps && finite_from_zero(stage_began_, last_insertion_, next_look_) &&
         stage_began_ <= time;
}

}  // namespace clogflow
