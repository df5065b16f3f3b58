#include "dem/run/arch.hpp"

#include <algorithm>
#include <cmath>

namespace clogflow {

namespace {

/// Contacts that press on each particle.
std::vector<int> contacts_of(const RunState& state) {
  std::vector<int> contacts(state.count(), 0);
  state.lists.pairs.for_each_contact([&](int i, int j, const auto&) { ++contacts[i], ++contacts[j]; });
  if (state.lists.walls.empty()) return contacts;
  for (const auto& touch : state.lists.walls.touches(state.particles)) ++contacts[touch.particle];
  return contacts;
}

/// A flat bottom of a silo bears a whole layer that is as near to the orifice; the arch is what reaches over it.
bool reaches_over(const Model& model, const ParticleState& p) {
  const Geometry& g = model.scene.geometry;
  if (!model.scene.falls() || !model.necks.empty()) return true;
  const double across = g.inlet_diameter > 0 ? std::hypot(p.y, p.z - g.neck_height / 2) : std::abs(p.y);
  return across < g.neck_width / 2 + p.radius;
}

}  // namespace

std::vector<int> arch_of(const RunState& state) {
  const Particles& p = state.particles;
  const std::vector<int> contacts = contacts_of(state);
  std::vector<int> bearing;
  double front = -1e300;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (contacts[i] < 2 || p[i].x >= state.model.domain.passage || !reaches_over(state.model, p[i])) continue;
    bearing.push_back(static_cast<int>(i));
    front = std::max(front, p[i].x);
  }
  std::erase_if(bearing, [&](int i) { return p[i].x < front - 2 * p[i].radius; });
  return bearing;
}

}  // namespace clogflow
