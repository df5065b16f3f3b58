#include "dem/run/rest_proof.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/base/quantile.hpp"
#include "dem/physics/drag.hpp"
#include "dem/run/whole_step.hpp"
#include "dem/state/external_force.hpp"

namespace clogflow {

namespace {

constexpr double slow_majority = 0.99;

double size_of(const Vec3& v) { return std::sqrt(dot(v, v)); }

}  // namespace

bool rests_for_good(const RunState& state) {
  const Scene& s = state.model.scene;
  const FlowDrive& drive = state.fluid.drive();
  if (!state.has_friction() || state.fluid.noise().on() || !drive.is_steady(state.time())) return false;
  const Inlet& inlet = state.inlet;
  if (inlet.enabled() &&
      (!inlet.waits(state.fluid, state.time()) || state.flow_time() < inlet.last_fed() + s.stokes_time()))
    return false;
  const Particles& p = state.particles;
  std::vector<double> speeds;
  std::vector<int> upstream;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p[i].x >= state.model.domain.passage) continue;
    speeds.push_back(size_of(p[i].velocity()));
    upstream.push_back(static_cast<int>(i));
  }
  if (speeds.empty()) return false;
  const double flow = std::abs(drive.factor()) * s.flow_speed(), scale = s.falls() ? s.speed_scale() : flow;
  if (*std::max_element(speeds.begin(), speeds.end()) > rattler_share * scale) return false;
  if (quantile(speeds, slow_majority) > rest_speed_share * scale) return false;
  std::vector<double> forces;
  for (const int i : upstream) {
    const double drive = stokes_coefficient(s.fluid.viscosity, 2 * p[i].radius) * flow +
                         size_of(external_force(s, p[i].mass, p[i].radius));
    forces.push_back(size_of(total_force(state, i)) / drive);
  }
  return quantile(forces, slow_majority) <= rest_force_share;
}

}  // namespace clogflow
