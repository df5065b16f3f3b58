#include "dem/protocol/clog_watch.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/base/quantile.hpp"
#include "coupling/scene/unclog_protocol.hpp"
#include "dem/protocol/frictionless_flow.hpp"

namespace clogflow {

namespace {

/// Length of channel, in neck widths, in which arches stand.
constexpr double clog_reach = 3;

/// Share of tau between two looks at the speeds.
constexpr double look_share = 0.1;

/// tau without a passage before a clog is looked for at all.
constexpr double least_wait = 0.5;

/// What ends a run without a proof is waited for so many times as long.
constexpr double unproved_wait = 4;

/// A creeping pack moves by a thousandth of a diameter while the flow moves by a diameter.
constexpr double rest_share = 1e-3;

}  // namespace

double look_interval(const Scene& scene) { return look_share * scene.stokes_time(); }

double rest_speed(const Scene& scene) { return rest_share * scene.speed_scale(); }

std::vector<int> near_neck(const Particles& p, const Scene& scene) {
  std::vector<int> near, all;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p[i].x >= scene.passages.plane) continue;
    all.push_back(static_cast<int>(i));
    if (p[i].x > -clog_reach * scene.geometry.neck_width) near.push_back(static_cast<int>(i));
  }
  return near.empty() ? all : near;
}

ClogState clog_state(const Particles& p, const Scene& scene) {
  std::vector<double> speeds;
  ClogState state{0, 0, -1e300};
  for (const int i : near_neck(p, scene)) {
    speeds.push_back(std::sqrt(p[i].vx * p[i].vx + p[i].vy * p[i].vy + p[i].vz * p[i].vz));
    state.position = std::max(state.position, p[i].x);
  }
  if (speeds.empty()) return {0, 0, 0};
  state.largest_speed = *std::max_element(speeds.begin(), speeds.end());
  state.quantile_speed = quantile(speeds, slow_share);
  return state;
}

ClogWatch::ClogWatch(const Scene& scene)
    : protocol_(scene.unclog.protocol),
      shortcut_(scene.unclog.shortcut),
      after_(scene.unclog.after),
      duration_(scene.unclog.duration),
      look_interval_(look_interval(scene)),
      rest_speed_(clogflow::rest_speed(scene)),
      least_wait_(least_wait * scene.stokes_time()),
      keeps_(rewinds()) {
  if (!restarts(protocol_)) return;
  enough_ = particles_of_strain(scene, scene.unclog.strain);
  duration_ = longest_flow(scene, scene.unclog.strain);
}

bool ClogWatch::flows_enough(double time, std::int64_t gone) const {
  if (time >= off_since_ + duration_) return true;
  return restarts(protocol_) && gone - gone_when_off_ >= enough_;
}

ClogWatch::Action ClogWatch::end_flow(double time) {
  friction_off_ = false;
  keeps_ = rewinds();
  last_event_ = time;
  return Action::friction_on;
}

ClogWatch::Action ClogWatch::begin(double time, std::int64_t gone) {
  last_event_ = time;
  if (protocol_ == UnclogProtocol::stop) {
    stopped_ = true;
    return Action::stop;
  }
  if (protocol_ == UnclogProtocol::poke) {
    pokes_ = true;
    return Action::poke;
  }
  friction_off_ = true;
  goes_back_ = rewinds();
  off_since_ = time;
  gone_when_off_ = gone;
  return Action::friction_off;
}

double ClogWatch::longest_wait() const { return protocol_ == UnclogProtocol::stop ? unproved_wait * after_ : after_; }

}  // namespace clogflow
