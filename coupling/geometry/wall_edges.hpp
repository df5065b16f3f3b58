// The edges of a surface of triangles, each with the triangles that meet in it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace clogflow {

/// An edge as one triangle uses it.
struct EdgeUse {
  int other;           ///< the larger corner number
  std::uint32_t side;  ///< 3 t + k: from corner k of triangle t to its next

  int triangle() const { return static_cast<int>(side / 3); }
  int k() const { return static_cast<int>(side % 3); }
};

/// All uses of edges, sorted: a list in place of a map, since files have millions.
class WallEdges {
public:
  /// \param corner   corner numbers of each triangle, in [0, corners)
  WallEdges(const std::vector<std::array<int, 3>>& corner, int corners);

  /// Calls visit(low, uses) for every edge, in the order of its corner numbers.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (std::size_t low = 0; low + 1 < begin_.size(); ++low)
      for (std::size_t i = begin_[low]; i < begin_[low + 1];) {
        std::size_t end = i;
        while (end < begin_[low + 1] && uses_[end].other == uses_[i].other) ++end;
        visit(static_cast<int>(low), std::span(uses_).subspan(i, end - i));
        i = end;
      }
  }

private:
  std::vector<std::size_t> begin_;  // of the uses of each smaller corner number
  std::vector<EdgeUse> uses_;
};

}  // namespace clogflow
