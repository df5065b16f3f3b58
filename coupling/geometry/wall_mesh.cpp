#include "coupling/geometry/wall_mesh.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include <fmt/format.h>

#include "coupling/geometry/hanging_corners.hpp"
#include "coupling/geometry/wall_edges.hpp"

namespace clogflow {

namespace {

bool has_area(const WeldedCorners& welded, const std::array<int, 3>& corner, double tolerance) {
  const auto& [a, b, c] = corner;
  if (a == b || b == c || c == a) return false;
  for (int k = 0; k < 3; ++k)
    if (share_on_edge(welded.place[corner[k]], welded.place[corner[(k + 1) % 3]], welded.place[corner[(k + 2) % 3]],
                      tolerance) > 0)
      return false;
  return true;
}

/// Numbers of triangles that have the corners of an earlier one.
std::vector<std::size_t> find_doubled(const std::vector<std::array<int, 3>>& corner) {
  std::vector<std::array<int, 4>> facets;  // corners in order, and the number
  facets.reserve(corner.size());
  for (std::size_t k = 0; k < corner.size(); ++k) {
    std::array<int, 3> sorted = corner[k];
    std::sort(sorted.begin(), sorted.end());
    facets.push_back({sorted[0], sorted[1], sorted[2], static_cast<int>(k)});
  }
  std::sort(facets.begin(), facets.end());
  std::vector<std::size_t> doubled;
  for (std::size_t k = 1; k < facets.size(); ++k)
    if (std::equal(facets[k].begin(), facets[k].begin() + 3, facets[k - 1].begin())) doubled.push_back(facets[k][3]);
  std::ranges::sort(doubled);
  return doubled;
}

void note(std::size_t& count, std::size_t& first, std::size_t number) {
  if (count++ == 0) first = number + 1;
}

/// Keeps the triangles for which `keep(position)` holds.
template <class Keep>
void keep_triangles(JoinedWalls& joined, const Keep& keep) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < joined.source.size(); ++t) {
    if (!keep(t)) continue;
    joined.welded.corner[kept] = joined.welded.corner[t];
    joined.source[kept++] = joined.source[t];
  }
  joined.welded.corner.resize(kept);
  joined.source.resize(kept);
}

/// Corners by their numbers; those of one rim under one representative.
class Rims {
public:
  explicit Rims(int corners) : parent_(corners) { std::iota(parent_.begin(), parent_.end(), 0); }
  void join(int a, int b) { parent_[root(a)] = root(b); }
  int root(int corner) {
    while (parent_[corner] != corner) corner = parent_[corner] = parent_[parent_[corner]];
    return corner;
  }

private:
  std::vector<int> parent_;
};

}  // namespace

std::string LeftOut::words() const {
  const auto part = [](std::size_t count, std::size_t first, const char* what) {
    return count == 0 ? ""
                      : fmt::format("{} facet{} {} (number {}{})", count, count > 1 ? "s" : "", what, first,
                                    count > 1 ? " the first" : "");
  };
  const std::string area = part(without_area, first_without_area, "without area"),
                    twice = part(doubled, first_doubled, "with the corners of another");
  if (count() == 0) return {};
  return area + (area.empty() || twice.empty() ? "" : " and ") + twice +
         (count() > 1 ? " are left out" : " is left out");
}

Walls JoinedWalls::walls() const {
  Walls result(welded.corner.size());
  for (std::size_t t = 0; t < result.size(); ++t)
    for (int k = 0; k < 3; ++k) result[t].corner[k] = welded.place[welded.corner[t][k]];
  return result;
}

JoinedWalls join_corners(const Walls& walls, double tolerance) {
  JoinedWalls joined{weld_corners(walls, tolerance), std::vector<int>(walls.size()), {}};
  std::iota(joined.source.begin(), joined.source.end(), 0);
  keep_triangles(joined, [&](std::size_t t) {
    const bool keep = has_area(joined.welded, joined.welded.corner[t], tolerance);
    if (!keep) note(joined.left_out.without_area, joined.left_out.first_without_area, joined.source[t]);
    return keep;
  });
  const std::vector<std::size_t> doubled = find_doubled(joined.welded.corner);
  for (const std::size_t t : doubled) note(joined.left_out.doubled, joined.left_out.first_doubled, joined.source[t]);
  if (!doubled.empty()) keep_triangles(joined, [&](std::size_t t) { return !std::ranges::binary_search(doubled, t); });
  return joined;
}

WallMesh cut_edges(JoinedWalls joined, double tolerance) {
  HangingCorners hanging = find_hanging(joined.welded, tolerance);
  WallMesh mesh{joined.walls(), std::move(joined.welded.corner), static_cast<int>(joined.welded.place.size())};
  if (hanging.empty()) return mesh;
  WallMesh cut{{}, {}, mesh.corners};
  joined.welded.corner = mesh.corner;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<std::vector<HangingCorner>, 3> on;
    for (int k = 0; k < 3; ++k)
      if (const auto found = hanging.find(static_cast<std::uint32_t>(3 * t + k)); found != hanging.end())
        on[k] = found->second;
    if (std::ranges::all_of(on, [](const auto& side) { return side.empty(); })) {
      cut.triangles.push_back(mesh.triangles[t]);
      cut.corner.push_back(mesh.corner[t]);
    } else {
      append_cut(joined.welded, t, on, cut.triangles, cut.corner);
    }
  }
  return cut;
}

double weld_length(const Walls& walls) { return weld_share * largest_extent(walls); }

WallMesh join_walls(const Walls& walls, double tolerance) {
  return cut_edges(join_corners(walls, tolerance), tolerance);
}

std::vector<WallRim> open_rims(const WallMesh& mesh) {
  Rims rims(mesh.corners);
  struct Open {
    int corner;
    double length;
    Vec3 place;
  };
  std::vector<Open> open;
  WallEdges(mesh.corner, mesh.corners).for_each([&](int low, std::span<const EdgeUse> uses) {
    if (uses.size() != 1) return;
    rims.join(low, uses[0].other);
    const auto& ends = mesh.triangles[uses[0].triangle()].corner;
    const Vec3 &a = ends[uses[0].k()], &b = ends[(uses[0].k() + 1) % 3];
    open.push_back({low, (b - a).norm(), mesh.corner[uses[0].triangle()][uses[0].k()] == low ? a : b});
  });
  std::map<int, WallRim> found;
  for (const auto& [corner, length, place] : open) {
    WallRim& rim = found[rims.root(corner)];
    rim.length += length;
    rim.place = place;
  }
  std::vector<WallRim> result;
  for (const auto& [corner, rim] : found) result.push_back(rim);
  std::ranges::sort(result, {}, &WallRim::length);
  return result;
}

}  // namespace clogflow
