#include "coupling/flow/flow_reach.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "coupling/geometry/channel_shape.hpp"
#include "coupling/geometry/duct_flow.hpp"
#include "coupling/geometry/stl_channel.hpp"

namespace clogflow {

namespace {

/// Largest difference from the duct profile in one plane of the grid, over the mean velocity [-].
double largest_difference(const FlowGrid& flow, const Scene& scene, const DuctFlow& duct, int i) {
  double largest = 0;
  for (int k = 0; k < flow.points[2]; ++k)
    for (int j = 0; j < flow.points[1]; ++j) {
      const std::size_t at = flow.index(i, j, k);
      if (flow.solid[at]) continue;
      const Vec3 place = flow.origin + flow.spacing * Vec3(i, j, k);
      const Vec3 developed(scene.flow.mean_velocity * duct(place.y, place.z), 0, 0);
      const Vec3 velocity(flow.velocity[3 * at], flow.velocity[3 * at + 1], flow.velocity[3 * at + 2]);
      largest = std::max(largest, (velocity - developed).norm());
    }
  return largest / scene.flow.mean_velocity;
}

}  // namespace

double expected_reach(const Scene& scene, double tolerance) {
  const double decay = scene.geometry.channel_width / (2 * std::numbers::pi);
  return std::max(0.0, -decay * std::log(tolerance));
}

double measured_reach(const FlowGrid& flow, const Scene& scene, double tolerance) {
  const DuctFlow duct = DuctFlow::of_channel(scene.geometry);
  const double narrowing = -narrowing_length(scene.geometry);
  for (int i = 0; i < flow.points[0]; ++i)
    if (largest_difference(flow, scene, duct, i) > tolerance)
      return i == 0 ? std::numeric_limits<double>::infinity()
                    : std::max(0.0, narrowing - (flow.origin.x + (i - 1) * flow.spacing));
  return 0;
}

std::optional<double> channel_pressure_drop(const FlowGrid& flow, const Scene& scene) {
  if (is_stl_channel(scene.geometry) || !flow.record.pressure_drop) return std::nullopt;
  const auto& g = scene.geometry;
  const double gradient =
      scene.fluid.viscosity * scene.flow.mean_velocity * DuctFlow(g.channel_width, g.neck_height).resistance();
  return *flow.record.pressure_drop + gradient * (g.channel_length - solved_length(scene.geometry));
}

}  // namespace clogflow
