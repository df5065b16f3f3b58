#include "dem/wall_surface.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "coupling/require.hpp"
#include "dem/closest_point.hpp"

namespace clog {

namespace {

/// Corners closer than this share of the surface's size are one corner; normals closer than this are
/// parallel. Files store coordinates with 7 digits or more.
constexpr double weld_share = 1e-7;

/// A triangle that comes closer by less than this share touches at the same place to rounding.
constexpr double same_distance = 1e-12;

Vec3 normal_of(const Triangle& t) {
  return (t.corner[1] - t.corner[0]).cross(t.corner[2] - t.corner[0]).normalized();
}

double distance_to_segment(const std::array<Vec3, 2>& segment, const Vec3& point) {
  const Vec3 along = segment[1] - segment[0];
  const double share = std::clamp((point - segment[0]).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (segment[0] + share * along - point).norm();
}

/// Welds corners that coincide: numbers them through a grid of the weld length, looking into the
/// neighbouring cells so that no pair is missed at a cell's border.
class Weld {
public:
  explicit Weld(double length) : length_(length) {}

  int number(const Vec3& corner) {
    const auto cell = [&](int a) { return static_cast<long>(std::floor(corner[a] / length_)); };
    for (long x = cell(0) - 1; x <= cell(0) + 1; ++x)
      for (long y = cell(1) - 1; y <= cell(1) + 1; ++y)
        for (long z = cell(2) - 1; z <= cell(2) + 1; ++z) {
          const auto found = cells_.find({x, y, z});
          if (found != cells_.end() && (corners_[found->second] - corner).norm() <= length_)
            return found->second;
        }
    corners_.push_back(corner);
    const int id = static_cast<int>(corners_.size()) - 1;
    cells_[{cell(0), cell(1), cell(2)}] = id;
    return id;
  }

  std::size_t size() const { return corners_.size(); }

private:
  double length_;
  std::vector<Vec3> corners_;
  std::map<std::array<long, 3>, int> cells_;
};

}  // namespace

WallSurface::WallSurface(const Walls& walls) : triangles_(walls) {
  Vec3 low = Vec3::Constant(1e300), high = Vec3::Constant(-1e300);
  for (const Triangle& t : triangles_)
    for (const Vec3& corner : t.corner) low = low.cwiseMin(corner), high = high.cwiseMax(corner);
  const double size = triangles_.empty() ? 1 : (high - low).norm();
  Weld weld(weld_share * size);
  for (std::size_t k = 0; k < triangles_.size(); ++k) {
    const Triangle& t = triangles_[k];
    const double area = (t.corner[1] - t.corner[0]).cross(t.corner[2] - t.corner[0]).norm() / 2;
    require(area > weld_share * weld_share * size * size,
            "walls: triangle {} has no area (a degenerate facet): remove it", k);
    corner_.push_back({weld.number(t.corner[0]), weld.number(t.corner[1]),
                       weld.number(t.corner[2])});
  }
  around_.resize(weld.size());
  for (std::size_t t = 0; t < corner_.size(); ++t)
    for (int corner : corner_[t]) around_[corner].push_back(static_cast<int>(t));
  find_patches();
}

void WallSurface::find_patches() {
  std::map<std::array<int, 2>, std::vector<int>> sharing;
  const auto edge = [&](int t, int k) {
    std::array<int, 2> ends{corner_[t][k], corner_[t][(k + 1) % 3]};
    std::sort(ends.begin(), ends.end());
    return ends;
  };
  for (int t = 0; t < static_cast<int>(size()); ++t)
    for (int k = 0; k < 3; ++k) sharing[edge(t, k)].push_back(t);

  patch_.assign(size(), -1);
  for (int seed = 0; seed < static_cast<int>(size()); ++seed) {
    if (patch_[seed] >= 0) continue;
    const int id = static_cast<int>(patches_.size());
    WallPatch patch{normal_of(triangles_[seed]), 0, {seed}, {}};
    patch.offset = patch.normal.dot(triangles_[seed].corner[0]);
    patch_[seed] = id;
    const auto joins = [&](int t) {
      return (normal_of(triangles_[t]) - patch.normal).norm() < weld_share;
    };
    for (std::size_t next = 0; next < patch.triangles.size(); ++next) {
      const int t = patch.triangles[next];
      for (int k = 0; k < 3; ++k) {
        bool inner = false;
        for (int other : sharing[edge(t, k)]) {
          if (other == t || !joins(other)) continue;
          inner = true;
          if (patch_[other] >= 0) continue;
          patch_[other] = id;
          patch.triangles.push_back(other);
        }
        if (!inner)
          patch.border.push_back({triangles_[t].corner[k], triangles_[t].corner[(k + 1) % 3]});
      }
    }
    patches_.push_back(patch);
  }
}

double WallSurface::distance(int triangle, const Vec3& centre) const {
  return (closest_point(triangles_[triangle], centre).point - centre).norm();
}

bool WallSurface::well_inside(const WallPatch& patch, const Vec3& centre, double margin) const {
  const double height = patch.normal.dot(centre) - patch.offset;
  const Vec3 foot = centre - height * patch.normal;
  const bool inside = std::any_of(patch.triangles.begin(), patch.triangles.end(), [&](int t) {
    return (closest_point(triangles_[t], foot).point - foot).norm() <= 1e-6 * margin;
  });
  return inside && height > 0 &&
         std::all_of(patch.border.begin(), patch.border.end(), [&](const auto& segment) {
           return distance_to_segment(segment, foot) > margin;
         });
}

void WallSurface::closest_points(const std::vector<int>& triangles, const Vec3& centre, double reach,
                                 std::vector<WallPoint>& found) const {
  const std::size_t begin = found.size();
  for (int t : triangles) {
    const ClosestPoint closest = closest_point(triangles_[t], centre);
    const Vec3 away = centre - closest.point;
    const double distance = away.norm();
    if (distance >= reach || distance == 0) continue;
    // Triangles around the edge or corner: one that comes closer holds the true contact.
    bool local_minimum = true;
    if (closest.corners < 3) {
      const int a = corner_[t][closest.at[0]], b = corner_[t][closest.at[1]];
      for (int other : around_[a]) {
        const auto& ends = corner_[other];
        if (other == t || std::find(ends.begin(), ends.end(), b) == ends.end()) continue;
        const double rival = (closest_point(triangles_[other], centre).point - centre).norm();
        local_minimum = local_minimum && rival >= distance * (1 - same_distance);
      }
    }
    const bool known = std::any_of(found.begin() + begin, found.end(), [&](const WallPoint& w) {
      return (w.point - closest.point).norm() < 1e-7 * reach;
    });
    if (local_minimum && !known) found.push_back({closest.point, away / distance, distance});
  }
}

}  // namespace clog
