// Walls for tests, and other triangulations of the same walls.
#pragma once

#include <random>

#include "coupling/geometry/walls.hpp"

namespace clogflow::test {

/// Corners counter-clockwise seen from the fluid.
inline void add_quad(Walls& walls, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  walls.push_back({{a, b, c}});
  walls.push_back({{a, c, d}});
}

/// The plane z = 0, |x|, |y| < size, fluid above.
inline Walls floor_plate(double size) {
  Walls walls;
  add_quad(walls, {-size, -size, 0}, {size, -size, 0}, {size, size, 0}, {-size, size, 0});
  return walls;
}

/// Two plates that meet in the y axis: the floor x < 0 at z = 0, and one that goes on from it turned
/// up (angle > 0, a re-entrant corner) or down (a convex edge). Fluid above.
inline Walls bent_plate(double angle, double size) {
  const Vec3 along(size * std::cos(angle), 0, size * std::sin(angle)), y(0, size, 0), x(size, 0, 0);
  Walls walls;
  add_quad(walls, -x - y, -y, y, -x + y);
  add_quad(walls, -y, along - y, along + y, y);
  return walls;
}

/// A place on a circle in the x-z plane.
inline Vec3 around(double angle, double radius, double y) {
  return {radius * std::cos(angle), y, radius * std::sin(angle)};
}

/// A closed round pore along y made of flat facets, the middle of the first at angle 0.
inline Walls round_pore(double radius, int facets, double half_length) {
  Walls walls;
  const double corner = radius / std::cos(M_PI / facets);  // the facets touch the circle
  for (int k = 0; k < facets; ++k) {
    const double from = (2 * k - 1) * M_PI / facets, to = (2 * k + 1) * M_PI / facets;
    const Vec3 a = around(from, corner, -half_length), b = around(to, corner, -half_length);
    const Vec3 c = around(to, corner, half_length), d = around(from, corner, half_length);
    add_quad(walls, d, c, b, a);
    walls.push_back({{a, b, Vec3(0, -half_length, 0)}});
    walls.push_back({{c, d, Vec3(0, half_length, 0)}});
  }
  return walls;
}

/// A floor that goes on along y, with the given corners in the x-z plane, from smaller x to larger. Fluid above.
inline Walls gutter(const std::vector<Vec3>& corners, double half_length) {
  Walls walls;
  const Vec3 y(0, half_length, 0);
  for (std::size_t k = 0; k + 1 < corners.size(); ++k)
    add_quad(walls, corners[k] - y, corners[k + 1] - y, corners[k + 1] + y, corners[k] + y);
  return walls;
}

/// The same surface cut finer: every triangle into four by the middles of its edges (which neighbours
/// share), or into three around a random inner point.
inline Walls cut_in_four(const Walls& walls) {
  Walls finer;
  for (const Triangle& t : walls) {
    const auto& [a, b, c] = t.corner;
    const Vec3 ab = (a + b) / 2, bc = (b + c) / 2, ca = (c + a) / 2;
    for (const Triangle& part : {Triangle{{a, ab, ca}}, {{ab, b, bc}}, {{ca, bc, c}}, {{ab, bc, ca}}})
      finer.push_back(part);
  }
  return finer;
}

inline Walls cut_in_three(const Walls& walls, std::mt19937& random) {
  std::uniform_real_distribution<double> share(0.1, 0.9);
  Walls finer;
  for (const Triangle& t : walls) {
    const auto& [a, b, c] = t.corner;
    const double u = share(random), v = share(random) * (1 - u);
    const Vec3 inside = (1 - u - v) * a + u * b + v * c;
    for (const Triangle& part : {Triangle{{a, b, inside}}, {{b, c, inside}}, {{c, a, inside}}}) finer.push_back(part);
  }
  return finer;
}

}  // namespace clogflow::test
