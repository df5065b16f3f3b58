#include "coupling/geometry/wall_sections.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace clogflow {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

// A wall whose normal has a smaller share along x is parallel to it: files hold few digits.
constexpr double parallel = 1e-3;

Vec3 area_vector(const Triangle& t) { return cross(t.corner[1] - t.corner[0], t.corner[2] - t.corner[0]) / 2; }

// The part of a convex polygon where sign * (x - plane) <= 0.
std::vector<Vec3> clip(const std::vector<Vec3>& polygon, double plane, double sign) {
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double from = sign * (a.x - plane), to = sign * (b.x - plane);
    if (from <= 0) kept.push_back(a);
    if ((from < 0 && to > 0) || (from > 0 && to < 0)) kept.push_back(a + from / (from - to) * (b - a));
  }
  return kept;
}

// Where the plane at x cuts a triangle, a piece of the section's outline.
void add_piece(const Triangle& t, double x, WallSection& section) {
  std::vector<Vec3> ends;
  for (int k = 0; k < 3; ++k) {
    const Vec3 &a = t.corner[k], &b = t.corner[(k + 1) % 3];
    if ((a.x < x) == (b.x < x)) continue;
    ends.push_back(a + (x - a.x) / (b.x - a.x) * (b - a));
  }
  if (ends.size() != 2) return;
  const Vec3 normal = area_vector(t), along = ends[1] - ends[0];
  // The fluid, where the normal points to, must lie on the left of the piece.
  if (along.y * normal.z - along.z * normal.y < 0) std::swap(ends[0], ends[1]);
  section.area += (ends[0].y * ends[1].z - ends[0].z * ends[1].y) / 2;
  for (const Vec3& end : ends) {
    section.y_min = std::min(section.y_min, end.y), section.y_max = std::max(section.y_max, end.y);
    section.z_min = std::min(section.z_min, end.z), section.z_max = std::max(section.z_max, end.z);
  }
}

}  // namespace

std::vector<WallSection> sections_at(const Walls& walls, const std::vector<double>& places) {
  const WallSection none{0, endless, -endless, endless, -endless};
  std::vector<WallSection> sections(places.size(), none);
  for (const Triangle& t : walls) {
    const auto& [a, b, c] = t.corner;
    const auto [first, last] = std::minmax({a.x, b.x, c.x});
    for (auto x = std::ranges::upper_bound(places, first); x != places.end() && *x <= last; ++x)
      add_piece(t, *x, sections[static_cast<std::size_t>(x - places.begin())]);
  }
  for (WallSection& section : sections)
    if (!(section.y_min < section.y_max)) section = {};
  return sections;
}

WallSection section_at(const Walls& walls, double x) { return sections_at(walls, {x})[0]; }

double neck_length(const Walls& walls, double from, double outlet) {
  const double widest = 1.01 * section_at(walls, from).area;
  constexpr int looks = 400;
  std::vector<double> places;
  for (int i = 1; i < looks; ++i) places.push_back(from + i * (outlet - from) / looks);
  const std::vector<WallSection> sections = sections_at(walls, places);
  const auto wide = std::ranges::find_if(sections, [&](const WallSection& section) { return section.area > widest; });
  if (wide == sections.end()) return outlet;
  double beyond = places[static_cast<std::size_t>(wide - sections.begin())];
  double within = std::max(from, beyond - (outlet - from) / looks);
  // A section is told from another to much less than the scene's rounding.
  for (int halving = 0; halving < 20; ++halving) {
    const double middle = (within + beyond) / 2;
    (section_at(walls, middle).area > widest ? beyond : within) = middle;
  }
  return within;
}

double volume_between(const Walls& walls, double from, double to) {
  double volume = 0;
  for (const Triangle& t : walls) {
    const std::vector<Vec3> piece = clip(clip({t.corner.begin(), t.corner.end()}, to, 1), from, -1);
    for (std::size_t i = 2; i < piece.size(); ++i) {
      const Triangle part{{piece[0], piece[i - 1], piece[i]}};
      // Normals point into the fluid, so the surface integral of y has the other sign.
      volume -= area_vector(part).y * (piece[0].y + piece[i - 1].y + piece[i].y) / 3;
    }
  }
  return volume;
}

double straight_until(const Walls& walls) {
  double until = endless;
  for (const Triangle& t : walls) {
    const Vec3 normal = area_vector(t).normalized();
    if (std::abs(normal.x) < parallel) continue;
    for (const Vec3& corner : t.corner) until = std::min(until, corner.x);
  }
  return until;
}

std::vector<bool> inside_along_z(const Walls& walls, double x, double y, const std::vector<double>& z) {
  std::vector<double> crossings;
  for (const Triangle& t : walls) {
    const auto& [a, b, c] = t.corner;
    if (std::max({a.x, b.x, c.x}) < x || std::min({a.x, b.x, c.x}) > x) continue;
    const auto turn = [&](const Vec3& from, const Vec3& to) {
      return (to.x - from.x) * (y - from.y) - (to.y - from.y) * (x - from.x);
    };
    const double wa = turn(b, c), wb = turn(c, a), wc = turn(a, b);
    const bool left = wa > 0 && wb > 0 && wc > 0, right = wa < 0 && wb < 0 && wc < 0;
    if (left || right) crossings.push_back((wa * a.z + wb * b.z + wc * c.z) / (wa + wb + wc));
  }
  std::ranges::sort(crossings);
  std::vector<bool> inside;
  for (const double height : z)
    inside.push_back((std::ranges::lower_bound(crossings, height) - crossings.begin()) % 2 == 1);
  return inside;
}

}  // namespace clogflow
