#include "coupling/geometry/wall_outlines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace clogflow {
namespace {

using Vec2 = Eigen::Vector2d;
using Point = std::pair<double, double>;

/// A plane normal to one axis; the other two are those of the picture.
struct Cut {
  int normal, u, v;
  double at;

  Vec2 flat(const Vec3& p) const { return {p[u], p[v]}; }
};

bool comes_first(const Vec3& a, const Vec3& b) { return a.array() < b.array(); }

/// Where an edge meets the plane: the same bits for both triangles of the edge.
Vec2 crossing(const Cut& cut, const Vec3& one, const Vec3& other) {
  const auto& [a, b] = comes_first(one, other) ? std::pair(one, other) : std::pair(other, one);
  return cut.flat(a + (cut.at - a[cut.normal]) / (b[cut.normal] - a[cut.normal]) * (b - a));
}

/// Pieces of the line by their beginnings.
std::multimap<Point, Point> pieces(const Walls& walls, const Cut& cut) {
  std::multimap<Point, Point> found;
  for (const Triangle& t : walls) {
    std::vector<Vec2> ends;
    for (int k = 0; k < 3; ++k) {
      const Vec3 &a = t.corner[k], &b = t.corner[(k + 1) % 3];
      if ((a[cut.normal] < cut.at) != (b[cut.normal] < cut.at)) ends.push_back(crossing(cut, a, b));
    }
    if (ends.size() != 2 || ends[0] == ends[1]) continue;
    const Vec2 normal = cut.flat(cross(t.corner[1] - t.corner[0], t.corner[2] - t.corner[0]));
    const Vec2 along = ends[1] - ends[0];
    if (along.x() * normal.y() - along.y() * normal.x() < 0) std::swap(ends[0], ends[1]);
    found.emplace(Point(ends[0].x(), ends[0].y()), Point(ends[1].x(), ends[1].y()));
  }
  return found;
}

std::vector<WallOutline> outlines(const Walls& walls, const Cut& cut) {
  auto left = pieces(walls, cut);
  std::map<Point, int> ends;
  for (const auto& [from, to] : left) ++ends[to];
  std::vector<WallOutline> lines;
  while (!left.empty()) {
    // A line that is open begins where no piece ends.
    auto at = std::ranges::find_if(left, [&](const auto& piece) { return ends[piece.first] == 0; });
    if (at == left.end()) at = left.begin();
    WallOutline line;
    const Point first = at->first;
    line.corners.emplace_back(first.first, first.second);
    while (at != left.end()) {
      const Point to = at->second;
      --ends[to];
      left.erase(at);
      line.closed = to == first;
      if (line.closed) break;
      line.corners.emplace_back(to.first, to.second);
      at = left.find(to);
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

Vec2 middle(const WallOutline& line) {
  Vec2 low = line.corners[0], high = low;
  for (const Vec2& corner : line.corners) low = low.cwiseMin(corner), high = high.cwiseMax(corner);
  return (low + high) / 2;
}

}  // namespace

double WallOutline::area() const {
  double twice = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

bool WallOutline::holds(const Vec2& at) const {
  bool inside = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    if ((a.y() > at.y()) == (b.y() > at.y())) continue;
    if (at.x() < a.x() + (at.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
  }
  return inside;
}

double WallOutline::distance(const Vec2& at) const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + (closed ? 0 : 1) < corners.size(); ++i) {
    const Vec2 &a = corners[i], along = corners[(i + 1) % corners.size()] - a;
    const double share = std::clamp((at - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (a + share * along - at).norm());
  }
  return least;
}

std::vector<WallOutline> cut_across(const Walls& walls, double x) { return outlines(walls, {0, 1, 2, x}); }

std::vector<WallOutline> cut_along(const Walls& walls, double z) { return outlines(walls, {2, 0, 1, z}); }

std::vector<WallOutline> openings_at(const Walls& walls, double x) {
  std::vector<WallOutline> openings;
  for (WallOutline& line : cut_across(walls, x))
    if (line.closed && line.area() > 0) openings.push_back(std::move(line));
  std::ranges::sort(openings, [](const WallOutline& a, const WallOutline& b) {
    const Vec2 p = middle(a), q = middle(b);
    return std::pair(p.x(), p.y()) < std::pair(q.x(), q.y());
  });
  return openings;
}

int opening_of(const std::vector<WallOutline>& openings, const Vec2& at) {
  int nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < openings.size(); ++k) {
    if (openings[k].holds(at)) return static_cast<int>(k);
    const double distance = openings[k].distance(at);
    if (distance < least) least = distance, nearest = static_cast<int>(k);
  }
  return nearest;
}

std::vector<WallOutline> closed_outlines(std::vector<WallOutline> lines) {
  const auto [open, whole] = [&] {
    std::pair<std::vector<WallOutline>, std::vector<WallOutline>> parts;
    for (WallOutline& line : lines) (line.closed ? parts.second : parts.first).push_back(std::move(line));
    return parts;
  }();
  std::vector<WallOutline> all = whole;
  // With the fluid on the left the line goes on at the nearest beginning on the same end of the channel.
  std::vector<WallOutline> rest = open;
  while (!rest.empty()) {
    WallOutline line = std::move(rest.back());
    rest.pop_back();
    for (;;) {
      const Vec2 end = line.corners.back();
      const auto gap = [&](const Vec2& from) {
        return std::abs(from.x() - end.x()) * 1e3 + std::abs(from.y() - end.y());
      };
      const auto next =
          std::ranges::min_element(rest, {}, [&](const WallOutline& other) { return gap(other.corners.front()); });
      if (next == rest.end() || gap(line.corners.front()) <= gap(next->corners.front())) break;
      line.corners.insert(line.corners.end(), next->corners.begin(), next->corners.end());
      rest.erase(next);
    }
    line.closed = true;
    all.push_back(std::move(line));
  }
  return all;
}

}  // namespace clogflow
