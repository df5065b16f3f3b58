// Particles sorted into cubic cells, and these in an order that keeps neighbours close in memory.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "coupling/geometry/walls.hpp"
#include "dem/state/particles.hpp"

namespace clogflow {

class Cells {
public:
  /// \param size  edge of a cell, at least the largest distance to be searched [m]
  Cells(const Particles& particles, double size);

  /// Particle indices, cell by cell; inside a cell in order of id, so that the result does not depend
  /// on the order in which the particles were stored.
  const std::vector<int>& order() const { return order_; }

  /// Once the particles stand in `order`: calls visit(i, j), i < j, for all that share a cell or
  /// stand in neighbouring ones, in ascending i from `from` to below `to`.
  template <class Visit>
  void for_each_pair(std::size_t from, std::size_t to, Visit&& visit) const;

private:
  /// Cells stand in columns along x, tile_edge wide: what a cell borders on is then seldom farther away
  /// in memory than the nearest cache holds.
  static constexpr int tile_edge = 8;

  int cell_index(int cx, int cy, int cz) const {
    const int tile = (cy / tile_edge) * tiles_z_ + cz / tile_edge;
    return ((tile * count_[0] + cx) * tile_edge + cy % tile_edge) * tile_edge + cz % tile_edge;
  }
  std::array<int, 3> place_of(int cell) const {
    const int z = cell % tile_edge, y = cell / tile_edge % tile_edge, column = cell / (tile_edge * tile_edge);
    const int x = column % count_[0], tile = column / count_[0];
    return {x, tile / tiles_z_ * tile_edge + y, tile % tiles_z_ * tile_edge + z};
  }

  std::array<int, 3> count_{};
  int tiles_z_ = 0;
  std::vector<int> start_;  // of each cell in order_, one more than there are cells
  std::vector<int> order_;
};

template <class Visit>
void Cells::for_each_pair(std::size_t from, std::size_t to, Visit&& visit) const {
  const int begin = static_cast<int>(from), end = static_cast<int>(to);
  const auto first = std::upper_bound(start_.begin(), start_.end(), begin) - 1;
  for (int own = static_cast<int>(first - start_.begin()); own + 1 < static_cast<int>(start_.size()); ++own) {
    if (start_[own] >= end) break;
    if (start_[own] == start_[own + 1]) continue;
    const auto [cx, cy, cz] = place_of(own);
    std::array<int, 27> later;  // neighbouring cells further on in the order
    int cells = 0;
    for (int x = std::max(cx - 1, 0); x <= std::min(cx + 1, count_[0] - 1); ++x)
      for (int y = std::max(cy - 1, 0); y <= std::min(cy + 1, count_[1] - 1); ++y)
        for (int z = std::max(cz - 1, 0); z <= std::min(cz + 1, count_[2] - 1); ++z)
          if (const int other = cell_index(x, y, z); other > own) later[cells++] = other;
    for (int i = std::max(start_[own], begin); i < std::min(start_[own + 1], end); ++i) {
      for (int j = i + 1; j < start_[own + 1]; ++j) visit(i, j);
      for (int k = 0; k < cells; ++k)
        for (int j = start_[later[k]]; j < start_[later[k] + 1]; ++j) visit(i, j);
    }
  }
}

}  // namespace clogflow
