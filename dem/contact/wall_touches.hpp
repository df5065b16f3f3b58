// Which places where a sphere touches a faceted wall are one touch.
#pragma once

#include <vector>

#include "coupling/geometry/walls.hpp"

namespace clogflow {

/// One place where a sphere is closest to the surface.
struct WallPoint {
  Vec3 point;        ///< on the surface [m]
  Vec3 normal;       ///< from the point to the sphere's centre [-]
  double distance;   ///< from the point to the sphere's centre [m]
  double share = 1;  ///< of the loads of a contact of its own [-]
};

/// Two touches whose normals turn by less than 25.8 degrees are one: facets of one curved wall, as a round
/// pore of 14 or more has them. Its cosine [-].
inline constexpr double one_touch = 0.9;

/// From 29.5 degrees on they are two, as in the corner of a box, at a chamfer or a narrowing. Its cosine [-].
inline constexpr double two_touches = 0.87;

/// A concave wall of facets touches a sphere once for each facet whose plane it reaches, about
/// R / (R - r) times in a pore of radius R however fine the facets are; the surface that they stand
/// for touches it once. So touches with nearly the same normal are joined:
///   s_ij = max(d_i, d_j) + x r / 10,  x = (one_touch - n_i.n_j) / (n_i.n_j - two_touches), 0 at
///   less, infinite at more L_i  = smallest over ways from i to a nearer touch of the largest s on
///   the way share_i = h_i (1 - (max(r - L_i, 0) / (r - d_i))^(3/2)) of a contact;  h_i (1 - (d_i -
///   r) / (L_i - r)) of a film h_i  = least over nearer touches j of (d_j - d_i n_i.n_j) / (d_i -
///   d_i n_i.n_j), from 0 to 1
/// with d the distances of the centre. The nearest touch of a curved wall carries the whole load of
/// its overlap, the others none; two hollows that a sphere bridges keep what each carries beyond
/// the brim between them. h is how far i rises from the plane of j: 1 where both are as near, 0
/// where i leaves its facet for the next, or is the border of a plate in the plane of j. So no load
/// jumps when touches come, go or change places. The normal is the mean of those of touches hardly
/// farther than the nearest, so it turns over from one facet to the next; an elastic bounce there
/// may win or lose 2 % of its energy. Neglects that a curved wall fits the sphere more closely: the
/// wall is locally flat. \param found   of one sphere; left as they are, bit for bit, where no two
/// normals are within
///                two_touches. Touches without a share are dropped.
/// \param radius  r of the sphere [m]
void join_touches(std::vector<WallPoint>& found, double radius);

}  // namespace clogflow
