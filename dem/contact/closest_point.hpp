// Closest point of a triangle, and on which of its parts it lies.
#pragma once

#include "coupling/geometry/walls.hpp"

namespace clogflow {

struct ClosestPoint {
  Vec3 point;             ///< [m]
  int corners;            ///< 3: inside the face, 2: on an edge, 1: at a corner
  std::array<int, 2> at;  ///< which corners of the triangle span the edge, or are the corner
};

/// Closest point of a triangle to a centre, by the Voronoi regions of its corners, edges and face.
/// \source Ericson, Real-Time Collision Detection (2005), sec. 5.1.5
inline ClosestPoint closest_point(const Triangle& triangle, const Vec3& centre) {
  const Vec3 &a = triangle.corner[0], &b = triangle.corner[1], &c = triangle.corner[2];
  const Vec3 ab = b - a, ac = c - a, ap = centre - a;
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return {a, 1, {0, 0}};
  const Vec3 bp = centre - b;
  const double d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return {b, 1, {1, 1}};
  const double area_c = d1 * d4 - d3 * d2;
  if (area_c <= 0 && d1 >= 0 && d3 <= 0) return {a + d1 / (d1 - d3) * ab, 2, {0, 1}};
  const Vec3 cp = centre - c;
  const double d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return {c, 1, {2, 2}};
  const double area_b = d5 * d2 - d1 * d6;
  if (area_b <= 0 && d2 >= 0 && d6 <= 0) return {a + d2 / (d2 - d6) * ac, 2, {0, 2}};
  const double area_a = d3 * d6 - d5 * d4;
  if (area_a <= 0 && d4 >= d3 && d5 >= d6) return {b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b), 2, {1, 2}};
  const double total = area_a + area_b + area_c;
  return {a + area_b / total * ab + area_c / total * ac, 3, {0, 0}};
}

}  // namespace clogflow
