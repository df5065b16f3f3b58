// The walls as one surface: where a sphere touches it, each face, edge and corner counted once.
#pragma once

#include <array>
#include <vector>

#include "coupling/geometry/wall_mesh.hpp"
#include "dem/contact/wall_touches.hpp"

namespace clogflow {

struct ClosestPoint;

/// A maximal flat piece: triangles in one plane joined by common edges.
struct WallPatch {
  Vec3 normal;    ///< into the fluid [-]
  double offset;  ///< normal . x on the plane [m]
  std::vector<int> triangles;
  std::vector<std::array<Vec3, 2>> border;  ///< edges that do not lie inside the patch
};

/// Triangles joined at common corners and edges. A contact is a local minimum of the distance to the whole
/// surface: the closest point of a triangle counts unless a triangle that shares its edge or corner
/// comes closer, and coinciding points count once. So the result does not depend on how a flat wall
/// is cut into triangles, and nothing jumps where a sphere crosses an edge. Where the centre lies on the
/// wall itself the normal is that of the triangle.
class WallSurface {
public:
  WallSurface() = default;
  explicit WallSurface(const Walls& walls) : WallSurface(walls, weld_length(walls)) {}
  /// \param weld  corners that are nearer than this are one [m]
  WallSurface(const Walls& walls, double weld);

  const std::vector<WallPatch>& patches() const { return patches_; }
  int patch_of(int triangle) const { return patch_[triangle]; }
  std::size_t size() const { return triangles_.size(); }
  /// As they were cut, see WallMesh: the numbers of all functions here.
  const Walls& triangles() const { return triangles_; }

  /// Distance of a point to a triangle [m].
  double distance(int triangle, const Vec3& centre) const;

  /// Whether a triangle is nearer than `reach` to a point.
  bool is_nearer(int triangle, const Vec3& centre, double reach) const;

  /// True if the point's foot on the patch's plane lies inside the patch and farther than `margin`
  /// from its border: then the patch is met in its inside, as an endless plane is. [m]
  bool well_inside(const WallPatch& patch, const Vec3& centre, double margin) const;

  /// True if a sphere that meets the inside of the patch may touch the triangle at nearly the same place:
  /// it rises from the patch at less than two_touches, or is of another patch in the same plane.
  bool may_share_a_touch(const WallPatch& patch, int triangle, double reach) const;

  /// All contacts of the given triangles nearer than `reach` to the centre; appended to `found`.
  void closest_points(const std::vector<int>& triangles, const Vec3& centre, double reach,
                      std::vector<WallPoint>& found) const;

private:
  struct Plane {
    Vec3 normal;
    double offset;  ///< normal . x [m]
  };

  void find_patches();

  /// Whether the height over a triangle's plane alone tells that it is farther than `reach`, as it does for most.
  bool is_beyond(int triangle, const Vec3& centre, double reach) const;
  bool neighbour_comes_closer(int triangle, const Vec3& centre, const ClosestPoint& closest) const;

  Walls triangles_;
  std::vector<std::array<int, 3>> corner_;  // corner numbers of each triangle
  std::vector<std::vector<int>> around_;    // triangles at each corner
  std::vector<Plane> plane_;                // of each triangle
  std::vector<int> patch_;
  std::vector<WallPatch> patches_;
};

}  // namespace clogflow
