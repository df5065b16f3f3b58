#include "coupling/flow/grid_from_samples.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "coupling/base/require.hpp"
#include "coupling/geometry/channel_shape.hpp"
#include "coupling/geometry/duct_flow.hpp"
#include "coupling/geometry/wall_sections.hpp"

namespace clogflow {
namespace {

// Flat cells cut the corners of curved walls: points there have no sample and count as solid.
constexpr double largest_lost_share = 0.02;

// The sampled row for a row -half_width <= j < half_width, and its sign for the y component.
struct Mirrored {
  int index;
  float sign;
};

Mirrored mirror_y(int j, int first) { return j >= first ? Mirrored{j, 1.0f} : Mirrored{-1 - j, -1.0f}; }

Mirrored mirror_z(int k, int layers) {
  const int other = layers - 1 - k;
  return k <= other ? Mirrored{k, 1.0f} : Mirrored{other, -1.0f};
}

FlowGrid empty_grid(const FlowLattice& lattice) {
  FlowGrid grid;
  const double h = lattice.spacing;
  grid.points = {lattice.x_end - lattice.x_begin, 2 * lattice.half_width, lattice.height};
  grid.origin = {lattice.coordinate(lattice.x_begin), lattice.coordinate(-lattice.half_width),
                 lattice.coordinate(lattice.z_begin)};
  grid.spacing = h;
  const std::size_t count = static_cast<std::size_t>(grid.points[0]) * grid.points[1] * grid.points[2];
  grid.velocity.resize(3 * count);
  grid.solid.resize(count);
  return grid;
}

class Mapper {
public:
  Mapper(const Scene& scene, const FlowLattice& lattice, const FoamSamples& samples)
      : scene_(scene),
        lattice_(lattice),
        samples_(samples),
        shape_(channel_shape(scene.geometry)),
        duct_(scene.geometry.channel_width, scene.geometry.neck_height) {}

  FlowGrid grid() const {
    FlowGrid grid = empty_grid(lattice_);
    for (int k = 0; k < grid.points[2]; ++k) {
      for (int j = 0; j < grid.points[1]; ++j) fill_row(grid, j, k);
    }
    return grid;
  }

private:
  void fill_row(FlowGrid& grid, int row, int k) const {
    const int j = row - lattice_.half_width;
    const double y = lattice_.coordinate(j);
    const auto developed = static_cast<float>(scene_.flow.mean_velocity * duct_(y, lattice_.coordinate(k)));
    const Mirrored my = mirror_y(j, lattice_.y_sampled);
    const Mirrored mz = mirror_z(k, lattice_.height);
    for (int i = lattice_.x_begin; i < lattice_.x_end; ++i) {
      const std::size_t at = grid.index(i - lattice_.x_begin, row, k);
      grid.solid[at] = is_solid(lattice_.coordinate(i), y);
      if (grid.solid[at]) continue;
      float* velocity = &grid.velocity[3 * at];
      if (i < lattice_.x_sampled) {
        velocity[0] = developed;
        continue;
      }
      const std::size_t from = samples_.index(i - lattice_.x_sampled, my.index - lattice_.y_sampled, mz.index);
      require(samples_.found[from],
              "no sample at ({}, {}, {}) m, inside the fluid (the samples file is incomplete); "
              "delete the "
              "file `solved` of the case and run its Allrun again",
              lattice_.coordinate(i), lattice_.coordinate(my.index), lattice_.coordinate(mz.index));
      velocity[0] = samples_.velocity[from][0];
      velocity[1] = my.sign * samples_.velocity[from][1];
      velocity[2] = mz.sign * samples_.velocity[from][2];
    }
  }

  // Points on a wall count as solid: OpenFOAM may or may not find them.
  bool is_solid(double x, double y) const {
    const double margin = 1e-6 * lattice_.spacing;
    const ChannelSide& side = y > 0 ? shape_.upper : shape_.lower;
    double wall = side.distance(x);
    for (const double near : {x - margin, x + margin}) wall = std::min(wall, side.distance(near));
    return std::abs(y) >= wall - margin;
  }

  const Scene& scene_;
  const FlowLattice& lattice_;
  const FoamSamples& samples_;
  ChannelShape shape_;
  DuctFlow duct_;
};

}  // namespace

FlowGrid grid_from_samples(const Scene& scene, const FlowLattice& lattice, const FoamSamples& samples) {
  return Mapper(scene, lattice, samples).grid();
}

FlowGrid stl_grid_from_samples(const Scene& scene, const FlowSpace& space, const FoamSamples& samples) {
  const FlowLattice& lattice = space.lattice;
  FlowGrid grid = empty_grid(lattice);
  const DuctFlow duct = DuctFlow::of_channel(scene.geometry);
  std::vector<double> heights;
  for (int k = 0; k < lattice.height; ++k) heights.push_back(lattice.coordinate(lattice.z_begin + k));
  std::size_t fluid = 0, lost = 0;
  for (int i = lattice.x_begin; i < lattice.x_end; ++i)
    for (int row = 0; row < grid.points[1]; ++row) {
      const double y = lattice.coordinate(row - lattice.half_width);
      const bool upstream = i < lattice.x_sampled;
      // Beside edges of triangles, which often lie on the grid's own planes.
      const double x = upstream ? space.straight : lattice.coordinate(i) + 1.3e-6 * lattice.spacing;
      const std::vector<bool> inside = inside_along_z(space.walls, x, y + 1.7e-6 * lattice.spacing, heights);
      for (int k = 0; k < lattice.height; ++k) {
        const std::size_t at = grid.index(i - lattice.x_begin, row, k);
        grid.solid[at] = !inside[k];
        if (!inside[k]) continue;
        ++fluid;
        float* velocity = &grid.velocity[3 * at];
        if (upstream) {
          velocity[0] = static_cast<float>(scene.flow.mean_velocity * duct(y, heights[k]));
          continue;
        }
        const std::size_t from = samples.index(i - lattice.x_sampled, row, k);
        lost += !samples.found[from];
        grid.solid[at] = !samples.found[from];
        for (int c = 0; c < 3; ++c) velocity[c] = samples.found[from] ? samples.velocity[from][c] : 0;
      }
    }
  const double share = static_cast<double>(lost) / static_cast<double>(std::max<std::size_t>(fluid, 1));
  require(share <= largest_lost_share,
          "{:.2g} % of the points between the walls have no sample (allowed {} %: the mesh does "
          "not follow "
          "the walls); refine flow.mesh_cells_per_neck",
          100 * share, 100 * largest_lost_share);
  grid.record.points_lost_at_walls = share;
  return grid;
}

}  // namespace clogflow
