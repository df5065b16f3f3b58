// Which triangles may be near a place: a regular grid over the walls.
#pragma once

#include <array>
#include <vector>

#include "coupling/geometry/walls.hpp"

namespace clogflow {

class WallBins {
public:
  WallBins() = default;

  /// \param reach  triangles nearer than this to a place are found there [m]
  WallBins(const Walls& walls, double reach);

  /// Triangles that may come nearer than the reach to the place; possibly more, none missed.
  const std::vector<int>& near(const Vec3& place) const;

private:
  std::array<int, 3> cell_of(const Vec3& place) const;
  std::size_t index(const std::array<int, 3>& cell) const {
    return (static_cast<std::size_t>(cell[0]) * count_[1] + cell[1]) * count_[2] + cell[2];
  }

  Vec3 low_ = Vec3::Zero();
  double edge_ = 1;
  std::array<int, 3> count_{1, 1, 1};
  std::vector<std::vector<int>> bins_{{}};
};

}  // namespace clogflow
