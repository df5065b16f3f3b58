#include "coupling/geometry/hanging_corners.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "coupling/geometry/wall_edges.hpp"

namespace clogflow {
namespace {

struct LooseEdge {
  int low, high;
  std::vector<std::uint32_t> sides;
};

std::vector<LooseEdge> find_loose(const WeldedCorners& welded) {
  std::vector<LooseEdge> loose;
  const auto forwards = [&](int low, const EdgeUse& use) { return welded.corner[use.triangle()][use.k()] == low; };
  WallEdges(welded.corner, static_cast<int>(welded.place.size())).for_each([&](int low, std::span<const EdgeUse> uses) {
    if (uses.size() == 2 && forwards(low, uses[0]) != forwards(low, uses[1])) return;
    loose.push_back({low, uses[0].other, {}});
    for (const EdgeUse& use : uses) loose.back().sides.push_back(use.side);
  });
  return loose;
}

/// The ends of loose edges in the cells of a grid, about one a cell where they lie along a surface.
class EndGrid {
public:
  EndGrid(const std::vector<LooseEdge>& loose, const std::vector<Vec3>& place, double tolerance)
      : tolerance_(tolerance) {
    std::vector<int> ends;
    for (const LooseEdge& edge : loose) ends.insert(ends.end(), {edge.low, edge.high});
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    Vec3 low = Vec3::Constant(1e300), high = -low;
    for (const int end : ends) low = low.cwiseMin(place[end]), high = high.cwiseMax(place[end]);
    low_ = low;
    // Never 0, also where squares of the lengths underflow.
    width_ =
        std::max({(high - low).maxCoeff() / std::sqrt(static_cast<double>(ends.size()) + 1), 4 * tolerance, 1e-150});
    for (const int end : ends) cells_.push_back({cell_of(place[end]), end});
    std::sort(cells_.begin(), cells_.end());
  }

  /// Calls visit(corner) for each end near the straight line from a to b, slice by slice along the
  /// axis that it follows most.
  template <class Visit>
  void along(const Vec3& a, const Vec3& b, const Visit& visit) const {
    const Vec3 way = b - a, size = way.cwiseAbs(), margin = Vec3::Constant(tolerance_);
    const int axis = size.x == size.maxCoeff() ? 0 : size.y == size.maxCoeff() ? 1 : 2;
    const int from = index(std::min(a[axis], b[axis]), axis, -tolerance_);
    const int to = index(std::max(a[axis], b[axis]), axis, tolerance_);
    for (int slice = from; slice <= to; ++slice) {
      const auto place_at = [&](double x) { return Vec3(a + std::clamp((x - a[axis]) / way[axis], 0.0, 1.0) * way); };
      const Vec3 p = place_at(low_[axis] + slice * width_ - tolerance_);
      const Vec3 q = place_at(low_[axis] + (slice + 1) * width_ + tolerance_);
      Cell low = cell_of(p.cwiseMin(q) - margin), high = cell_of(p.cwiseMax(q) + margin);
      low[axis] = high[axis] = slice;
      visit_cells(low, high, visit);
    }
  }

private:
  using Cell = std::array<int, 3>;

  int index(double x, int axis, double by) const {
    return static_cast<int>(std::floor((x + by - low_[axis]) / width_));
  }

  Cell cell_of(const Vec3& p) const { return {index(p.x, 0, 0), index(p.y, 1, 0), index(p.z, 2, 0)}; }

  template <class Visit>
  void visit_cells(const Cell& low, const Cell& high, const Visit& visit) const {
    for (int x = low[0]; x <= high[0]; ++x)
      for (int y = low[1]; y <= high[1]; ++y) {
        // Cells are sorted by x, y, z: those between two z follow one another.
        auto it = std::lower_bound(cells_.begin(), cells_.end(), std::pair(Cell{x, y, low[2]}, -1));
        for (; it != cells_.end() && it->first <= Cell{x, y, high[2]}; ++it) visit(it->second);
      }
  }

  double tolerance_, width_;
  Vec3 low_;
  std::vector<std::pair<Cell, int>> cells_;
};

/// Two that are nearer to each other than the tolerance along the edge would leave a piece without
/// area.
void keep_apart(std::vector<HangingCorner>& hanging, double least_share) {
  std::sort(hanging.begin(), hanging.end(), [](const HangingCorner& a, const HangingCorner& b) {
    return std::tie(a.share, a.number) < std::tie(b.share, b.number);
  });
  std::vector<HangingCorner> kept;
  for (const HangingCorner& h : hanging)
    if (kept.empty() || h.share - kept.back().share > least_share) kept.push_back(h);
  hanging = std::move(kept);
}

}  // namespace

double share_on_edge(const Vec3& a, const Vec3& b, const Vec3& p, double tolerance) {
  const Vec3 along = b - a;
  const double square = along.squaredNorm(), share = dot(p - a, along) / square;
  const double least = tolerance / std::sqrt(square);
  if (!(share > least && share < 1 - least)) return 0;
  return (p - a - share * along).cwiseAbs().maxCoeff() <= tolerance ? share : 0;
}

HangingCorners find_hanging(const WeldedCorners& welded, double tolerance) {
  HangingCorners found;
  const std::vector<LooseEdge> loose = find_loose(welded);
  if (loose.empty()) return found;
  const auto& place = welded.place;
  const EndGrid grid(loose, place, tolerance);
  for (const LooseEdge& edge : loose) {
    const Vec3 &a = place[edge.low], &b = place[edge.high];
    std::vector<HangingCorner> hanging;
    grid.along(a, b, [&](int number) {
      if (number == edge.low || number == edge.high) return;
      if (const double share = share_on_edge(a, b, place[number], tolerance); share > 0)
        hanging.push_back({number, share});
    });
    if (hanging.empty()) continue;
    keep_apart(hanging, tolerance / (b - a).norm());
    for (const std::uint32_t side : edge.sides) {
      auto& there = found[side] = hanging;
      if (welded.corner[side / 3][side % 3] == edge.low) continue;
      std::reverse(there.begin(), there.end());
      for (HangingCorner& h : there) h.share = 1 - h.share;
    }
  }
  return found;
}

void append_cut(const WeldedCorners& welded, std::size_t t, const std::array<std::vector<HangingCorner>, 3>& hanging,
                std::vector<Triangle>& triangles, std::vector<std::array<int, 3>>& corner) {
  struct Point {
    Vec3 place;
    int number;
  };
  // A side from its first corner to its last, both included.
  const auto points = [&](int k) {
    const int a = welded.corner[t][k], b = welded.corner[t][(k + 1) % 3];
    const Vec3 &from = welded.place[a], along = welded.place[b] - from;
    std::vector<Point> all{{from, a}};
    for (const HangingCorner& h : hanging[k]) all.push_back({from + h.share * along, h.number});
    all.push_back({welded.place[b], b});
    return all;
  };
  const auto append = [&](const Point& a, const Point& b, const Point& c) {
    triangles.push_back({{a.place, b.place, c.place}});
    corner.push_back({a.number, b.number, c.number});
  };
  int k = 0;
  while (k < 2 && hanging[k].empty()) ++k;
  const std::vector<Point> base = points(k), up = points((k + 1) % 3), down = points((k + 2) % 3);
  // From the tip over the inner points of the base; its two end pieces are cut along the other
  // sides.
  const std::size_t last = base.size() - 2;
  for (std::size_t i = 0; i + 1 < down.size(); ++i) append(down[i + 1], base[1], down[i]);
  for (std::size_t i = 1; i < last; ++i) append(base[i], base[i + 1], down[0]);
  for (std::size_t i = 0; i + 1 < up.size(); ++i) append(base[last], up[i], up[i + 1]);
}

}  // namespace clogflow
