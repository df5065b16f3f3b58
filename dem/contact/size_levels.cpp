#include "dem/contact/size_levels.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "coupling/base/expect.hpp"

namespace clogflow {

namespace {

/// Scenes with a few far-away particles must not allocate cells by the million.
constexpr int most_cells_along = 256;

constexpr double ParticleState::*coordinate[3] = {&ParticleState::x, &ParticleState::y, &ParticleState::z};

}  // namespace

std::array<int, 3> SizeLevels::Level::cell_of(const ParticleState& particle) const {
  std::array<int, 3> cell{};
  for (int a = 0; a < 3; ++a)
    cell[a] = std::clamp(static_cast<int>(std::floor((particle.*coordinate[a] - low[a]) / edge)), 0, count[a] - 1);
  return cell;
}

SizeLevels::SizeLevels(const Particles& p, const Reach& reach, double largest, double smallest)
    : particles_(p), level_(p.size()) {
  expect(p.size() > 0 && smallest > 0 && smallest <= largest);
  const int levels = 1 + static_cast<int>(std::floor(std::log2(largest / smallest)));
  std::array<double, 3> low{}, span{};
  for (int a = 0; a < 3; ++a) {
    const auto [least, most] = std::ranges::minmax_element(p.states, {}, coordinate[a]);
    low[a] = (*least).*coordinate[a];
    span[a] = (*most).*coordinate[a] - low[a];
  }
  for (int k = 0; k < levels; ++k) {
    const double radius = std::ldexp(largest, -k);
    Level level;
    level.low = low;
    level.edge = std::max(reach.of(radius, radius), *std::ranges::max_element(span) / most_cells_along);
    for (int a = 0; a < 3; ++a) level.count[a] = 1 + static_cast<int>(span[a] / level.edge);
    levels_.push_back(std::move(level));
  }
  for (std::size_t i = 0; i < p.size(); ++i) {
    int& level = level_[i];
    while (level + 1 < levels && p[i].radius <= std::ldexp(largest, -level - 1)) ++level;
  }
  for (std::size_t k = 0; k < levels_.size(); ++k) sort_in(p, k);
}

void SizeLevels::sort_in(const Particles& p, std::size_t number) {
  Level& level = levels_[number];
  level.start.assign(static_cast<std::size_t>(level.count[0]) * level.count[1] * level.count[2] + 1, 0);
  std::vector<int> cell(p.size(), -1);
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (level_[i] != static_cast<int>(number)) continue;
    const auto [x, y, z] = level.cell_of(p[i]);
    cell[i] = level.index(x, y, z);
    ++level.start[cell[i] + 1];
  }
  std::partial_sum(level.start.begin(), level.start.end(), level.start.begin());
  std::vector<int> next(level.start.begin(), level.start.end() - 1);
  level.members.resize(level.start.back());
  for (std::size_t i = 0; i < p.size(); ++i)
    if (cell[i] >= 0) level.members[next[cell[i]]++] = static_cast<int>(i);
}

}  // namespace clogflow
