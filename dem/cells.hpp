// Particles sorted into cubic cells along x, then y, then z: the order that keeps neighbours close
// in memory.
#pragma once

#include <array>
#include <vector>

#include "coupling/walls.hpp"
#include "dem/particles.hpp"

namespace clog {

class Cells {
public:
  /// \param size  edge of a cell, at least the largest distance to be searched [m]
  Cells(const Particles& particles, double size);

  /// Particle indices, cell by cell; inside a cell in order of id, so that the result does not depend
  /// on the order in which the particles were stored.
  const std::vector<int>& order() const { return order_; }

  /// Once the particles stand in `order`: calls visit(i, j), i < j, for all that share a cell or
  /// stand in neighbouring ones, in ascending i.
  template <class Visit>
  void for_each_pair(Visit&& visit) const;

private:
  int cell_index(int cx, int cy, int cz) const { return (cx * count_[1] + cy) * count_[2] + cz; }

  std::array<int, 3> count_{};
  std::vector<int> start_;  // of each cell in order_, one more than there are cells
  std::vector<int> order_;
};

template <class Visit>
void Cells::for_each_pair(Visit&& visit) const {
  for (int cx = 0; cx < count_[0]; ++cx)
    for (int cy = 0; cy < count_[1]; ++cy)
      for (int cz = 0; cz < count_[2]; ++cz) {
        const int own = cell_index(cx, cy, cz);
        for (int i = start_[own]; i < start_[own + 1]; ++i) {
          for (int j = i + 1; j < start_[own + 1]; ++j) visit(i, j);
          for (int x = cx; x <= cx + 1 && x < count_[0]; ++x)
            for (int y = cy - 1; y <= cy + 1; ++y)
              for (int z = cz - 1; z <= cz + 1; ++z) {
                if (y < 0 || y >= count_[1] || z < 0 || z >= count_[2]) continue;
                const int other = cell_index(x, y, z);
                if (other <= own) continue;
                for (int j = start_[other]; j < start_[other + 1]; ++j) visit(i, j);
              }
        }
      }
}

}  // namespace clog
