#include "coupling/flow_mesh.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/channel_shape.hpp"
#include "coupling/require.hpp"

namespace clog {
namespace {

// Disturbances of the narrowing die out upstream like exp(-2 pi x / width), so 1.25 widths leave
// 4e-4.
constexpr double development_widths = 1.25;
constexpr double shortest_upstream_widths = 0.5;

// The neck's entrance flow develops within about one neck height at Reynolds numbers of order one.
constexpr double neck_continuation = 0.5;

// The arc at `wall` that meets the wall with half of the angle between the two walls: its tangent
// turns by half the half angle between axis and wall.
MeshStation arc_station(double wall, double half_width, double half_angle) {
  const double turn = half_angle / 2;
  const double radius = half_width / std::sin(turn);
  const double axis = wall - half_width * std::tan(turn / 2);
  const double centre = axis + radius;
  return {.wall = wall,
          .axis = axis,
          .arc = {centre - radius * std::cos(turn / 2), radius * std::sin(turn / 2)}};
}

// Number of cells on a length whose sizes change geometrically from `first` to `last`.
int cells_between(double length, double first, double last) {
  if (std::abs(first / last - 1) < 1e-3)
    return std::max(2, static_cast<int>(std::ceil(length / first)));
  const double ratio = (length - first) / (length - last);
  return std::max(4, static_cast<int>(std::lround(1 + std::log(last / first) / std::log(ratio))));
}

int at_least(int least, double cells) {
  return std::max(least, static_cast<int>(std::lround(cells)));
}

}  // namespace

double graded_edge(int edge, int cells, double grading) {
  if (cells == 1 || grading == 1) return static_cast<double>(edge) / cells;
  const double ratio = std::pow(grading, 1.0 / (cells - 1));
  return (std::pow(ratio, edge) - 1) / (std::pow(ratio, cells) - 1);
}

FlowMesh flow_mesh(const Scene& scene) {
  const auto& g = scene.geometry;
  require(g.present, "the scene has no section [geometry]; a flow case needs one");
  require(g.stl.empty(), "geometry.stl = {} (a flow case is made for the parametric channel only)",
          g.stl);
  require(
      g.channel_width > 1.001 * g.neck_width,
      "geometry.channel_width = {} m (must exceed neck_width = {} m: the mesh needs a narrowing)",
      g.channel_width, g.neck_width);
  const double cell = g.neck_width / scene.flow.mesh_cells_per_neck;
  const double bend = -narrowing_length(scene);
  const double widest = std::max(g.channel_width, g.neck_height);
  const double neck_side = std::max(g.neck_width, g.neck_height);

  FlowMesh mesh{};
  mesh.wide_corner = arc_station(bend, g.channel_width / 2, g.half_angle);
  mesh.neck_edge = arc_station(0, g.neck_width / 2, g.half_angle);
  mesh.inlet = bend - std::clamp(g.channel_length, shortest_upstream_widths * widest,
                                 development_widths * widest);
  mesh.middle = g.neck_width / 2;
  mesh.outlet = std::max(g.neck_length, neck_side) + neck_continuation * neck_side;
  mesh.cells_across = at_least(4, scene.flow.mesh_cells_per_neck / 2);
  // The parabola across the height is smooth: it needs fewer cells than the neighbourhood of the
  // edge.
  mesh.cells_high = at_least(4, 0.42 * g.neck_height / cell);

  // Sizes along the wall: nearly square cells at the neck's edge, and about as long as wide at the
  // wide corner. The ratios are those that gave the smallest error for a 60 degree narrowing from 4
  // to 1.
  const double slope = (g.channel_width - g.neck_width) / 2 / std::sin(g.half_angle);
  const double at_edge = 0.45 * cell;
  const double at_corner =
      std::clamp(1.4 * g.channel_width / scene.flow.mesh_cells_per_neck, slope / 16, slope / 4);
  const double before_corner = at_corner / 2;
  const double straight = bend - mesh.inlet;
  const double at_inlet = std::max(0.13 * straight, before_corner);
  const double in_neck = std::min(2.4 * cell, mesh.middle / 3);

  mesh.upstream = {cells_between(straight, at_inlet, before_corner), before_corner / at_inlet,
                   before_corner / at_inlet};
  mesh.narrowing = {cells_between(slope, at_corner, at_edge),
                    std::min(1.0, 3 * at_edge / at_corner), at_edge / at_corner};
  mesh.entrance = {cells_between(mesh.middle, at_edge, in_neck), 0.7 * in_neck / at_edge,
                   in_neck / at_edge};
  mesh.neck = {cells_between(mesh.outlet - mesh.middle, 3 * cell, 3 * cell), 1, 1};
  return mesh;
}

}  // namespace clog
