#include "coupling/flow/straight_flux.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/base/require.hpp"
#include "coupling/flow/flow_flux.hpp"
#include "coupling/geometry/channel_shape.hpp"

namespace clogflow {
namespace {

/// From a wall to the first point: the parabola through zero there and the first two points.
struct Margin {
  double integral, slope;  ///< slope at the first point
};

Margin margin(double first, double second, double wall) {
  const double curvature = second / (wall + 1) - first / wall;
  const double slope_at_wall = first / wall - curvature * wall;
  return {slope_at_wall * wall * wall / 2 + curvature * wall * wall * wall / 3, slope_at_wall + 2 * curvature * wall};
}

/// Flux through one plane over spacing squared; none where the section is too narrow for it.
double plane_flux(const FlowGrid& grid, int i, const ChannelShape& shape) {
  const double x = grid.origin.x + i * grid.spacing;
  const double low = -shape.lower.distance(x), high = shape.upper.distance(x);
  std::vector<double> layers, row;
  for (int k = 0; k < grid.points[2]; ++k) {
    row.clear();
    int first = -1, last = -1;
    for (int j = 0; j < grid.points[1]; ++j) {
      const std::size_t at = grid.index(i, j, k);
      if (grid.solid[at]) continue;
      if (first < 0) first = j;
      last = j;
      row.push_back(grid.velocity[3 * at]);
    }
    if (row.size() < 2) return 0;
    layers.push_back(integral_between_walls(row, (grid.origin.y - low) / grid.spacing + first,
                                            (high - grid.origin.y) / grid.spacing - last));
  }
  // The layers lie half a spacing from the walls.
  return layers.size() < 2 ? 0 : integral_between_walls(layers, 0.5, 0.5);
}

}  // namespace

double integral_between_walls(const std::vector<double>& values, double before, double behind) {
  const std::size_t n = values.size();
  const Margin begin = margin(values[0], values[1], before), end = margin(values[n - 1], values[n - 2], behind);
  double sum = (values[0] + values[n - 1]) / 2;
  for (std::size_t i = 1; i + 1 < n; ++i) sum += values[i];
  // The trapezoidal rule and its first correction (Euler-Maclaurin).
  return begin.integral + end.integral + sum + (begin.slope + end.slope) / 12;
}

double restore_flow_rate(FlowGrid& grid, const Scene& scene) {
  const auto& g = scene.geometry;
  const ChannelShape shape = channel_shape(scene.geometry);
  const double bend = -narrowing_length(scene.geometry);
  const double rate = scene.flow.mean_velocity * g.channel_width * g.neck_height;
  double largest = 0;
  // The first plane is the series solution of the duct, better than the rule for its flux.
  for (int i = 1; i < grid.points[0]; ++i) {
    const double x = grid.origin.x + i * grid.spacing;
    const bool expanded = g.expansion_width > 0 && x > 0 && shape.width(x) > (1 - 1e-9) * g.expansion_width;
    if (x > bend && !expanded) continue;
    const double flux = plane_flux(grid, i, shape) * grid.spacing * grid.spacing;
    const double error = flux / rate - 1;
    require(std::abs(error) < flux_tolerance,
            "the flux through x = {} m differs by {:.1f} % from that of the scene (allowed {} %); "
            "refine "
            "flow.mesh_cells_per_neck or flow.grid_spacing",
            x, 100 * error, 100 * flux_tolerance);
    largest = std::max(largest, std::abs(error));
    for (int k = 0; k < grid.points[2]; ++k)
      for (int j = 0; j < grid.points[1]; ++j)
        for (int c = 0; c < 3; ++c) {
          float& component = grid.velocity[3 * grid.index(i, j, k) + c];
          component = static_cast<float>(component * (rate / flux));
        }
  }
  return largest;
}

}  // namespace clogflow
