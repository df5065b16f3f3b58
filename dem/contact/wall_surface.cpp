#include "dem/contact/wall_surface.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "dem/contact/closest_point.hpp"

namespace clogflow {

namespace {

/// Normals closer than this are parallel. Files store coordinates with 7 digits or more.
constexpr double same_normal = 1e-7;

/// A triangle that comes closer by less than this share touches at the same place to rounding.
constexpr double same_distance = 1e-12;

/// A height over a plane that is larger than the reach by this share is so beyond rounding.
constexpr double beyond_rounding = 1e-9;

/// Places closer than this share of the reach are one.
constexpr double one_place = 1e-7;

Vec3 normal_of(const Triangle& t) { return cross(t.corner[1] - t.corner[0], t.corner[2] - t.corner[0]).normalized(); }

double squared_distance_to_segment(const std::array<Vec3, 2>& segment, const Vec3& point) {
  const Vec3 along = segment[1] - segment[0];
  const double share = std::clamp(dot(point - segment[0], along) / along.squaredNorm(), 0.0, 1.0);
  return (segment[0] + share * along - point).squaredNorm();
}

}  // namespace

WallSurface::WallSurface(const Walls& walls, double weld) {
  WallMesh mesh = join_walls(walls, weld);
  triangles_ = std::move(mesh.triangles);
  corner_ = std::move(mesh.corner);
  around_.resize(mesh.corners);
  for (std::size_t t = 0; t < corner_.size(); ++t)
    for (int corner : corner_[t]) around_[corner].push_back(static_cast<int>(t));
  for (const Triangle& triangle : triangles_) {
    const Vec3 normal = normal_of(triangle);
    plane_.push_back({normal, dot(normal, triangle.corner[0])});
  }
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
    patch.offset = dot(patch.normal, triangles_[seed].corner[0]);
    patch_[seed] = id;
    const auto joins = [&](int t) { return (normal_of(triangles_[t]) - patch.normal).norm() < same_normal; };
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
        if (!inner) patch.border.push_back({triangles_[t].corner[k], triangles_[t].corner[(k + 1) % 3]});
      }
    }
    patches_.push_back(patch);
  }
}

double WallSurface::distance(int triangle, const Vec3& centre) const {
  return (closest_point(triangles_[triangle], centre).point - centre).norm();
}

bool WallSurface::is_beyond(int triangle, const Vec3& centre, double reach) const {
  const Plane& plane = plane_[triangle];
  return std::abs(dot(plane.normal, centre) - plane.offset) > reach * (1 + beyond_rounding);
}

bool WallSurface::is_nearer(int triangle, const Vec3& centre, double reach) const {
  return !is_beyond(triangle, centre, reach) && distance(triangle, centre) < reach;
}

bool WallSurface::well_inside(const WallPatch& patch, const Vec3& centre, double margin) const {
  const double height = dot(patch.normal, centre) - patch.offset;
  const Vec3 foot = centre - height * patch.normal;
  if (!(height > 0)) return false;
  const bool off_border = std::all_of(patch.border.begin(), patch.border.end(), [&](const auto& segment) {
    return squared_distance_to_segment(segment, foot) > margin * margin;
  });
  return off_border && std::any_of(patch.triangles.begin(), patch.triangles.end(),
                                   [&](int t) { return distance(t, foot) <= 1e-6 * margin; });
}

bool WallSurface::may_share_a_touch(const WallPatch& patch, int triangle, double reach) const {
  const Vec3& normal = patches_[patch_[triangle]].normal;
  const double cosine = dot(patch.normal, normal);
  if (cosine <= two_touches || &patch == &patches_[patch_[triangle]]) return false;
  const auto& corner = triangles_[triangle].corner;
  const auto height = [&](const Vec3& c) { return dot(patch.normal, c) - patch.offset; };
  const double highest = std::max({height(corner[0]), height(corner[1]), height(corner[2])});
  const bool same_plane = (normal - patch.normal).norm() < same_normal && std::abs(highest) <= one_place * reach;
  return same_plane || highest > one_place * reach;
}

bool WallSurface::neighbour_comes_closer(int triangle, const Vec3& centre, const ClosestPoint& closest) const {
  const double distance = (closest.point - centre).norm();
  const int a = corner_[triangle][closest.at[0]], b = corner_[triangle][closest.at[1]];
  return std::any_of(around_[a].begin(), around_[a].end(), [&](int other) {
    const auto& ends = corner_[other];
    if (other == triangle || std::find(ends.begin(), ends.end(), b) == ends.end()) return false;
    return !(this->distance(other, centre) >= distance * (1 - same_distance));
  });
}

void WallSurface::closest_points(const std::vector<int>& triangles, const Vec3& centre, double reach,
                                 std::vector<WallPoint>& found) const {
  const std::size_t begin = found.size();
  for (int t : triangles) {
    if (is_beyond(t, centre, reach)) continue;
    const ClosestPoint closest = closest_point(triangles_[t], centre);
    const Vec3 away = centre - closest.point;
    const double distance = away.norm();
    if (distance >= reach) continue;
    // Triangles around the edge or corner: one that comes closer holds the true contact.
    if (closest.corners < 3 && neighbour_comes_closer(t, centre, closest)) continue;
    const bool known = std::any_of(found.begin() + begin, found.end(), [&](const WallPoint& w) {
      return (w.point - closest.point).norm() < one_place * reach;
    });
    if (known) continue;
    const Vec3 normal = distance > 0 ? Vec3(away / distance) : patches_[patch_[t]].normal;
    found.push_back({closest.point, normal, distance});
  }
}

}  // namespace clogflow
