#include "coupling/flow/flow_flux.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/base/require.hpp"
#include "coupling/geometry/channel_shape.hpp"

namespace clogflow {
namespace {

/// The outermost points lie half a spacing before the walls where these are whole spacings apart, else up to
/// one and a half.
constexpr double most_spacings_to_wall = 1.5 + 1e-6;

void check_reach(const FlowGrid& grid, int axis, double from, double to) {
  const double first = grid.origin[axis], last = first + (grid.points[axis] - 1) * grid.spacing;
  const double allowed = most_spacings_to_wall * grid.spacing;
  require(
      std::abs(first - from) <= allowed && std::abs(last - to) <= allowed,
      "the grid of the flow file lies elsewhere: {} from {:.6g} to {:.6g} m, the channel from {:.6g} to {:.6g} m; make "
      "it anew with clog map",
      "xyz"[axis], first, last, from, to);
}

void check_covers_walls(const FlowGrid& grid, const Scene& scene) {
  Vec3 low = Vec3::Constant(1e300), high = -low;
  for (const Triangle& t : grid.walls)
    for (const Vec3& corner : t.corner) low = low.cwiseMin(corner), high = high.cwiseMax(corner);
  for (const int across : {1, 2}) check_reach(grid, across, low[across], high[across]);
  // Upstream the grid may begin anywhere that the flow is developed: its first plane stands for the rest.
  check_reach(grid, 0, std::min(grid.origin.x, -narrowing_length(scene.geometry)), channel_end(scene.geometry));
}

}  // namespace

double grid_flux(const FlowGrid& grid, int i) {
  const std::span<const float> field = grid.field();
  double sum = 0;
  for (int k = 0; k < grid.points[2]; ++k) {
    for (int j = 0; j < grid.points[1]; ++j) sum += field[3 * grid.index(i, j, k)];
  }
  return sum * grid.spacing * grid.spacing;
}

PlaneFlux grid_plane(const FlowGrid& grid, int i, const Scene& scene) {
  const double rate = channel_flow_rate(scene.geometry, scene.flow.mean_velocity);
  const double flux = grid_flux(grid, i);
  return {grid.origin.x + i * grid.spacing, flux, flux / rate - 1};
}

std::vector<PlaneFlux> grid_fluxes(const FlowGrid& grid, const Scene& scene, double first) {
  const auto& g = scene.geometry;
  const double bend = -narrowing_length(scene.geometry);
  std::vector<PlaneFlux> planes;
  for (const double x : {first, bend - g.neck_width, bend, bend / 2, 0.0, g.neck_length / 2, g.neck_length,
                         channel_end(scene.geometry)}) {
    const int i = static_cast<int>(std::lround((x - grid.origin.x) / grid.spacing));
    if (i < 0 || i >= grid.points[0]) continue;
    planes.push_back(grid_plane(grid, i, scene));
  }
  return planes;
}

void check_flow_fits(const FlowGrid& grid, const Scene& scene) {
  check_covers_walls(grid, scene);
  for (const PlaneFlux& plane : grid_fluxes(grid, scene, grid.origin.x))
    require(std::abs(plane.error) < flux_tolerance,
            "the flow file carries {:.4g} m3/s through x = {:.4g} m, which is {:.4g} % off the flow rate of the scene "
            "(allowed {} %): make it anew with clog case and clog map",
            plane.flux, plane.x, 100 * plane.error, 100 * flux_tolerance);
}

}  // namespace clogflow
