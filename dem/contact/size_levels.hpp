// Pairs of very unequal spheres: a grid for each class of sizes.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "dem/contact/reach.hpp"
#include "dem/state/particles.hpp"

namespace clogflow {

/// One grid whose cells fit the largest sphere holds hundreds of small ones a cell, and all of them are compared. Here
/// each class of sizes, from some radius down to half of it, has a grid of its own; a sphere is looked for in the grid
/// of its class and in those of larger ones, 27 cells each, so that the work is in proportion to the number of pairs.
/// \source Iwai, Hong & Greil, Int. J. Mod. Phys. C 10 (1999) 823; Ogarko & Luding, Comput. Phys. Commun. 183 (2012)
/// 931
class SizeLevels {
public:
  /// \param largest, smallest  radius of any [m]
  SizeLevels(const Particles& particles, const Reach& reach, double largest, double smallest);

  /// Calls visit(i, j), i < j, for all that may be within reach of each other; in an order that their places and
  /// numbers decide.
  template <class Visit>
  void for_each_pair(Visit&& visit) const;

private:
  struct Level {
    double edge = 0;  ///< of a cell [m]
    std::array<double, 3> low{};
    std::array<int, 3> count{};
    std::vector<int> start;    ///< of each cell in `members`, one more than there are cells
    std::vector<int> members;  ///< cell by cell, in ascending number

    std::array<int, 3> cell_of(const ParticleState& particle) const;
    int index(int x, int y, int z) const { return (x * count[1] + y) * count[2] + z; }
  };

  void sort_in(const Particles& particles, std::size_t level);

  template <class Visit>
  void visit_around(const Level& level, int i, Visit&& visit) const;

  const Particles& particles_;
  std::vector<int> level_;  // of each particle
  std::vector<Level> levels_;
};

template <class Visit>
void SizeLevels::visit_around(const Level& level, int i, Visit&& visit) const {
  const auto [cx, cy, cz] = level.cell_of(particles_[i]);
  for (int x = std::max(cx - 1, 0); x <= std::min(cx + 1, level.count[0] - 1); ++x)
    for (int y = std::max(cy - 1, 0); y <= std::min(cy + 1, level.count[1] - 1); ++y) {
      // Cells along z stand in a row.
      const int from = level.start[level.index(x, y, std::max(cz - 1, 0))];
      const int to = level.start[level.index(x, y, std::min(cz + 1, level.count[2] - 1)) + 1];
      for (int k = from; k < to; ++k) visit(level.members[k]);
    }
}

template <class Visit>
void SizeLevels::for_each_pair(Visit&& visit) const {
  for (int i = 0; i < static_cast<int>(particles_.size()); ++i) {
    const int own = level_[i];
    visit_around(levels_[own], i, [&](int j) {
      if (j > i) visit(i, j);
    });
    for (int larger = 0; larger < own; ++larger)
      visit_around(levels_[larger], i, [&](int j) { visit(std::min(i, j), std::max(i, j)); });
  }
}

}  // namespace clogflow
