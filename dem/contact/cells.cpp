#include "dem/contact/cells.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "coupling/base/expect.hpp"
#include "dem/kernels/grid_place.hpp"

namespace clogflow {

namespace {

/// A scene with a few far-away particles must not allocate cells by the million.
constexpr int most_cells_per_axis = 512;

}  // namespace

Cells::Cells(const Particles& p, double size) {
  expect(size > 0);
  constexpr double ParticleState::*axis[3] = {&ParticleState::x, &ParticleState::y, &ParticleState::z};
  std::array<double, 3> low{}, edge{};
  for (int a = 0; a < 3; ++a) {
    const auto [least, most] = std::ranges::minmax_element(p.states, {}, axis[a]);
    const double span = p.size() ? (*most).*axis[a] - (*least).*axis[a] : 0;
    low[a] = p.size() ? (*least).*axis[a] : 0;
    count_[a] = std::max(1, cell_number(span / size, most_cells_per_axis + 1));
    edge[a] = std::max(size, span / count_[a]);
  }
  const auto cell_of = [&](std::size_t i) {
    int c[3];
    for (int a = 0; a < 3; ++a) c[a] = cell_number((p[i].*axis[a] - low[a]) / edge[a], count_[a]);
    return cell_index(c[0], c[1], c[2]);
  };
  std::vector<int> cell(p.size());
  const auto tiles = [&](int axis) { return (count_[axis] + tile_edge - 1) / tile_edge; };
  tiles_z_ = tiles(2);
  start_.assign(static_cast<std::size_t>(tiles(1)) * tiles_z_ * count_[0] * tile_edge * tile_edge + 1, 0);
  for (std::size_t i = 0; i < p.size(); ++i) {
    cell[i] = cell_of(i);
    ++start_[cell[i] + 1];
  }
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  std::vector<int> next(start_.begin(), start_.end() - 1);
  order_.resize(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) order_[next[cell[i]]++] = static_cast<int>(i);
  for (std::size_t c = 0; c + 1 < start_.size(); ++c)
    std::sort(order_.begin() + start_[c], order_.begin() + start_[c + 1],
              [&](int a, int b) { return p.id[a] < p.id[b]; });
}

}  // namespace clogflow
