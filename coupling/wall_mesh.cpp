#include "coupling/wall_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "coupling/require.hpp"

namespace clog {

namespace {

/// Corners closer than this share of the surface's size are one corner. Files store coordinates with 7
/// digits or more.
constexpr double weld_share = 1e-7;

double area_of(const Triangle& t) {
  return (t.corner[1] - t.corner[0]).cross(t.corner[2] - t.corner[0]).norm() / 2;
}

double size_of(const Walls& walls) {
  Vec3 low = Vec3::Constant(1e300), high = Vec3::Constant(-1e300);
  for (const Triangle& t : walls)
    for (const Vec3& corner : t.corner) low = low.cwiseMin(corner), high = high.cwiseMax(corner);
  return walls.empty() ? 1 : (high - low).norm();
}

/// Numbers corners, those that coincide alike, through a grid of the weld length; it looks into the
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

  const std::vector<Vec3>& corners() const { return corners_; }

private:
  double length_;
  std::vector<Vec3> corners_;
  std::map<std::array<long, 3>, int> cells_;
};

/// Cuts triangles at the corners that lie on their edges.
class Cutter {
public:
  Cutter(const std::vector<Vec3>& corners, double length) : corners_(corners), length_(length), by_x_(corners.size()) {
    std::iota(by_x_.begin(), by_x_.end(), 0);
    std::sort(by_x_.begin(), by_x_.end(), [&](int a, int b) { return corners_[a].x() < corners_[b].x(); });
  }

  void cut(const Triangle& triangle, const std::array<int, 3>& corner, WallMesh& mesh) const {
    cut_at(triangle, corner, near(triangle), mesh);
  }

private:
  /// Corners in the box around the triangle.
  std::vector<int> near(const Triangle& t) const {
    const auto& [a, b, c] = t.corner;
    const Vec3 low = a.cwiseMin(b).cwiseMin(c) - Vec3::Constant(length_);
    const Vec3 high = a.cwiseMax(b).cwiseMax(c) + Vec3::Constant(length_);
    const auto before = [&](int k, double x) { return corners_[k].x() < x; };
    std::vector<int> found;
    for (auto k = std::lower_bound(by_x_.begin(), by_x_.end(), low.x(), before);
         k != by_x_.end() && corners_[*k].x() <= high.x(); ++k)
      if ((corners_[*k].array() >= low.array()).all() && (corners_[*k].array() <= high.array()).all())
        found.push_back(*k);
    return found;
  }

  void cut_at(const Triangle& t, const std::array<int, 3>& corner, const std::vector<int>& near, WallMesh& mesh) const {
    for (const int hanging : near) {
      if (std::find(corner.begin(), corner.end(), hanging) != corner.end()) continue;
      for (int k = 0; k < 3; ++k) {
        const Vec3 &a = t.corner[k], &b = t.corner[(k + 1) % 3], &c = t.corner[(k + 2) % 3];
        const Vec3 along = b - a;
        const double share = (corners_[hanging] - a).dot(along) / along.squaredNorm();
        // On the edge itself, so that the pieces lie in the triangle's plane.
        const Vec3 at = a + share * along;
        if (share <= 0 || share >= 1 || (corners_[hanging] - at).norm() > length_) continue;
        cut_at({{a, at, c}}, {corner[k], hanging, corner[(k + 2) % 3]}, near, mesh);
        cut_at({{at, b, c}}, {hanging, corner[(k + 1) % 3], corner[(k + 2) % 3]}, near, mesh);
        return;
      }
    }
    mesh.triangles.push_back(t);
    mesh.corner.push_back(corner);
  }

  const std::vector<Vec3>& corners_;
  double length_;
  std::vector<int> by_x_;
};

/// Triangle numbers in messages count from 1.
void refuse_twins(const std::vector<std::array<int, 3>>& corner) {
  std::map<std::array<int, 3>, std::size_t> seen;
  for (std::size_t k = 0; k < corner.size(); ++k) {
    auto key = corner[k];
    std::sort(key.begin(), key.end());
    const auto [first, is_new] = seen.try_emplace(key, k);
    require(is_new, "walls: triangle {} has the corners of triangle {}: remove one of them", k + 1,
            first->second + 1);
  }
}

}  // namespace

WallMesh join_walls(const Walls& walls) {
  const double size = size_of(walls), length = weld_share * size;
  Weld weld(length);
  std::vector<std::array<int, 3>> corner;
  for (std::size_t k = 0; k < walls.size(); ++k) {
    const auto& [a, b, c] = walls[k].corner;
    corner.push_back({weld.number(a), weld.number(b), weld.number(c)});
    const auto& n = corner.back();
    require(area_of(walls[k]) > length * length && n[0] != n[1] && n[1] != n[2] && n[2] != n[0],
            "walls: triangle {} has no area (a degenerate facet): remove it", k + 1);
  }
  refuse_twins(corner);
  WallMesh mesh;
  mesh.corners = static_cast<int>(weld.corners().size());
  const Cutter cutter(weld.corners(), length);
  for (std::size_t k = 0; k < walls.size(); ++k) cutter.cut(walls[k], corner[k], mesh);
  return mesh;
}

std::vector<WallRim> open_rims(const WallMesh& mesh) {
  struct Edge {
    int uses = 0;
    double length = 0;
  };
  std::map<std::array<int, 2>, Edge> edges;
  std::vector<Vec3> place(mesh.corners);
  for (std::size_t t = 0; t < mesh.corner.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int a = mesh.corner[t][k], b = mesh.corner[t][(k + 1) % 3];
      place[a] = mesh.triangles[t].corner[k];
      Edge& edge = edges[{std::min(a, b), std::max(a, b)}];
      ++edge.uses;
      edge.length = (mesh.triangles[t].corner[(k + 1) % 3] - place[a]).norm();
    }
  // Corners of one rim under one representative.
  std::vector<int> parent(mesh.corners);
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int c) {
    while (parent[c] != c) c = parent[c] = parent[parent[c]];
    return c;
  };
  for (const auto& [ends, edge] : edges)
    if (edge.uses == 1) parent[root(ends[0])] = root(ends[1]);
  std::map<int, WallRim> found;
  for (const auto& [ends, edge] : edges) {
    if (edge.uses != 1) continue;
    WallRim& rim = found[root(ends[0])];
    rim.length += edge.length;
    rim.place = place[ends[0]];
  }
  std::vector<WallRim> rims;
  for (const auto& [corner, rim] : found) rims.push_back(rim);
  std::sort(rims.begin(), rims.end(), [](const WallRim& a, const WallRim& b) { return a.length < b.length; });
  return rims;
}

}  // namespace clog
