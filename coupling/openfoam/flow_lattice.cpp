#include "coupling/openfoam/flow_lattice.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/base/require.hpp"
#include "coupling/geometry/channel_shape.hpp"

namespace clogflow {
namespace {

// 13 bytes each; OpenFOAM writes them as text first.
constexpr double most_points = 1e9;

}  // namespace

void require_layers(const Scene& scene) {
  const auto& g = scene.geometry;
  const double h = scene.flow.grid_spacing;
  const double layers = g.neck_height / h;
  // Rounding of decimal lengths stays far below 1e-6 of a layer; no other ratio should pass.
  require(std::abs(layers - std::round(layers)) < 1e-6 && layers > 0.5,
          "flow.grid_spacing = {} m (it must divide geometry.neck_height = {} m into whole layers); "
          "use for example {} m",
          h, g.neck_height, g.neck_height / std::max(1.0, std::ceil(layers)));
  const double points =
      (channel_end(scene.geometry) - channel_start(scene.geometry)) * g.channel_width * g.neck_height / (h * h * h);
  require(points < most_points,
          "flow.grid_spacing = {:.4g} m (a grid of {:.2g} points, more than {:.0g}); raise it, or the "
          "flow.grid_tolerance it follows from",
          h, points, most_points);
}

FlowLattice flow_lattice(const Scene& scene, const FlowMesh& mesh) {
  const auto& g = scene.geometry;
  const double h = scene.flow.grid_spacing;
  require_layers(scene);
  const auto index_at = [&](double x) { return x / h - 0.5; };
  FlowLattice lattice{};
  lattice.spacing = h;
  lattice.x_end = static_cast<int>(std::ceil(index_at(channel_end(scene.geometry)))) + 1;
  lattice.x_sampled = static_cast<int>(std::floor(index_at(mesh.inlet()))) + 1;
  lattice.x_begin = lattice.x_sampled - 1;
  lattice.half_width = static_cast<int>(std::ceil(std::max(g.channel_width, g.expansion_width) / 2 / h - 1e-6));
  lattice.y_sampled = mesh.sides() == 1 ? 0 : -lattice.half_width;
  lattice.height = static_cast<int>(std::lround(g.neck_height / h));
  return lattice;
}

}  // namespace clogflow
