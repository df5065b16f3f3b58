#include "coupling/geometry/wall_edges.hpp"

#include <algorithm>
#include <tuple>

namespace clogflow {

WallEdges::WallEdges(const std::vector<std::array<int, 3>>& corner, int corners)
    : begin_(static_cast<std::size_t>(corners) + 1), uses_(3 * corner.size()) {
  const auto ends = [&](std::size_t t, int k) { return std::minmax({corner[t][k], corner[t][(k + 1) % 3]}); };
  for (std::size_t t = 0; t < corner.size(); ++t)
    for (int k = 0; k < 3; ++k) ++begin_[ends(t, k).first + 1];
  for (std::size_t low = 1; low < begin_.size(); ++low) begin_[low] += begin_[low - 1];
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t t = 0; t < corner.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = ends(t, k);
      uses_[next[low]++] = {high, static_cast<std::uint32_t>(3 * t + k)};
    }
  for (std::size_t low = 0; low + 1 < begin_.size(); ++low)
    std::sort(uses_.begin() + static_cast<std::ptrdiff_t>(begin_[low]),
              uses_.begin() + static_cast<std::ptrdiff_t>(begin_[low + 1]),
              [](const EdgeUse& a, const EdgeUse& b) { return std::tie(a.other, a.side) < std::tie(b.other, b.side); });
}

}  // namespace clogflow
