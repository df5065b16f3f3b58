#include "dem/fluid/local_porosity.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/base/expect.hpp"
#include "coupling/geometry/wall_sections.hpp"
#include "dem/fluid/porosity_strips.hpp"
#include "dem/physics/porosity.hpp"

namespace clogflow {

namespace {

/// Places a cell and direction at which the channel's volume is looked up.
constexpr int places = 4;

/// A column's places across are moved from one column to the next by the golden section, so that no wall lies between
/// the same two of them in all: its place is known to some hundredth of a cell after the smoothing.
constexpr double golden = 0.6180339887498949;

/// Keeps places off the edges of triangles, which belong to two.
constexpr double aside = 1.7e-6;

SmoothGrid grid_of(const ChannelSpace& space, double width) {
  Vec3 low = space.walls[0].corner[0], high = low;
  for (const Triangle& t : space.walls)
    for (const Vec3& corner : t.corner) low = low.cwiseMin(corner), high = high.cwiseMax(corner);
  low.x = space.start, high.x = space.end;
  return {low, high, width};
}

SmoothGrid::Values volume_at_points(const Walls& walls, const SmoothGrid& grid) {
  SmoothGrid::Values volume(grid.size(), 0.0f);
  std::vector<double> heights(places * grid.cells(2));
  const double dx = grid.spacing(0) / places, dy = grid.spacing(1) / places, dz = grid.spacing(2) / places;
  for (std::size_t k = 0; k < heights.size(); ++k) heights[k] = grid.low().z + (static_cast<double>(k) + 0.5) * dz;
  for (int i = 0; i < places * grid.cells(0); ++i) {
    const double x = grid.low().x + (i + 0.5 + aside) * dx, moved = i * golden - std::floor(i * golden);
    for (int j = 0; j < places * grid.cells(1); ++j) {
      const double y = grid.low().y + (j + moved) * dy;
      const std::vector<bool> inside = inside_along_z(walls, x, y, heights);
      for (std::size_t k = 0; k < heights.size(); ++k)
        if (inside[k]) grid.add(volume, {x, y, heights[k]}, dx * dy * dz);
    }
  }
  return volume;
}

}  // namespace

LocalPorosity::LocalPorosity(const ChannelSpace& space, double width)
    : grid_(grid_of(space, width)), per_space_(volume_at_points(space.walls, grid_)), porosity_(grid_.size(), 1.0f) {
  grid_.smooth(per_space_);
  for (float& volume : per_space_) volume = volume > 0 ? 1 / volume : 0;
}

void LocalPorosity::update(const Particles& p) {
  SmoothGrid::Values solid(grid_.size(), 0.0f);
  for (std::size_t i = 0; i < p.size(); ++i) grid_.add(solid, p[i].position(), sphere_volume(p[i].radius));
  grid_.smooth(solid);
  constexpr auto least = static_cast<float>(least_porosity);
  for (std::size_t k = 0; k < solid.size(); ++k) porosity_[k] = std::max(least, 1 - solid[k] * per_space_[k]);
}

bool LocalPorosity::valid() const {
  constexpr auto least = static_cast<float>(least_porosity);
  return porosity_.size() == per_space_.size() &&
         std::ranges::all_of(porosity_, [](float eps) { return eps >= least && eps <= 1; });
}

}  // namespace clogflow
