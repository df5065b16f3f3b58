#include "dem/run/clog_watch.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/base/quantile.hpp"

namespace clogflow {

namespace {

/// Length of channel, in neck widths, in which arches stand.
constexpr double clog_reach = 3;

/// Share of tau between two looks at the speeds.
constexpr double look_share = 0.1;

/// A creeping pack moves by a thousandth of a diameter while the flow moves by a diameter.
constexpr double rest_share = 1e-3;

}  // namespace

double rest_speed(const Scene& scene) { return rest_share * scene.flow_speed(); }

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
    : enabled_(scene.unclog.protocol == UnclogProtocol::release),
      after_(scene.unclog.after),
      duration_(scene.unclog.duration),
      look_interval_(look_share * scene.stokes_time()),
      rest_speed_(clogflow::rest_speed(scene)) {}

}  // namespace clogflow
