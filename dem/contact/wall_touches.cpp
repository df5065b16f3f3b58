#include "dem/contact/wall_touches.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace clogflow {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Touches that are farther than the nearest by more than this share of the overlap (or gap) do not
/// turn its normal. Smaller would make valleys between two facets stiffer than their contacts are,
/// and larger would let the normal depend on where the facets are small.
constexpr double blend_share = 0.1;

/// The same at no overlap, where nothing may be divided by zero, over the radius.
constexpr double least_blend = 1e-6;

/// How far beyond the touches their brim is where the normals are half-way from one touch to two,
/// over the radius: a tenth is a deep overlap.
constexpr double brim_height = 0.1;

/// Distance of the centre at which two touches are one, see join_touches [m].
double brim(const WallPoint& a, const WallPoint& b, double radius) {
  const double cosine = dot(a.normal, b.normal);
  if (cosine <= two_touches) return infinite;
  const double x = cosine >= one_touch ? 0 : (one_touch - cosine) / (cosine - two_touches);
  return std::max(a.distance, b.distance) + brim_height * x * radius;
}

bool any_near(const std::vector<WallPoint>& found) {
  for (std::size_t i = 0; i < found.size(); ++i)
    for (std::size_t j = i + 1; j < found.size(); ++j)
      if (dot(found[i].normal, found[j].normal) > two_touches) return true;
  return false;
}

/// The smallest of the highest brims of all ways from one touch to each other (Prim's algorithm).
std::vector<double> highest_brims(const std::vector<WallPoint>& found, std::size_t from, double radius) {
  std::vector<double> highest(found.size(), infinite);
  std::vector<char> reached(found.size(), 0);
  highest[from] = found[from].distance;
  for (std::size_t k = 0; k < found.size(); ++k) {
    std::size_t next = found.size();
    for (std::size_t i = 0; i < found.size(); ++i)
      if (!reached[i] && (next == found.size() || highest[i] < highest[next])) next = i;
    if (highest[next] == infinite) break;
    reached[next] = 1;
    for (std::size_t i = 0; i < found.size(); ++i)
      if (!reached[i]) highest[i] = std::min(highest[i], std::max(highest[next], brim(found[next], found[i], radius)));
  }
  return highest;
}

/// h of join_touches. \param i  in order of distance
double rise(const std::vector<WallPoint>& found, std::size_t i) {
  double least = 1;
  for (std::size_t j = 0; j < i; ++j) {
    const double cosine = dot(found[i].normal, found[j].normal), along = found[i].distance * cosine;
    const double whole = found[i].distance - along;
    if (cosine > two_touches && whole > 0) least = std::min(least, (found[j].distance - along) / whole);
  }
  return std::max(least, 0.0);
}

/// Share of a touch's loads that a touch joined to it at this distance carries already.
double merged_share(double distance, double joined, double radius) {
  if (joined == infinite) return 0;
  const double overlap = radius - distance;
  if (overlap > 0) return std::pow(std::max(radius - joined, 0.0) / overlap, 1.5);
  return joined > radius ? -overlap / (joined - radius) : 1;
}

/// The mean normal of a touch and of those hardly farther that are one with it; not longer than
/// one. \param merged  shares of all touches that are one with this touch and with no nearer one
Vec3 mean_normal(const std::vector<WallPoint>& found, std::size_t touch, const std::vector<double>& merged,
                 double radius) {
  const Vec3& own = found[touch].normal;
  const double nearest = found[touch].distance;
  const double range = blend_share * std::abs(radius - nearest) + least_blend * radius;
  Vec3 turned = Vec3::Zero();
  double sum = range;
  for (std::size_t i = touch + 1; i < found.size() && found[i].distance < nearest + range; ++i) {
    const double weight = rise(found, i) * (nearest + range - found[i].distance);
    sum += weight;
    turned += weight * merged[i] * (found[i].normal - own);
  }
  return own + turned / sum;
}

}  // namespace

void join_touches(std::vector<WallPoint>& found, double radius) {
  if (!any_near(found)) return;
  std::stable_sort(found.begin(), found.end(),
                   [](const WallPoint& a, const WallPoint& b) { return a.distance < b.distance; });
  std::vector<WallPoint> joined;
  std::vector<double> carried(found.size(), 0),
      merged(found.size());  // by nearer touches, and by this one beyond that
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double share = (1 - carried[i]) * rise(found, i);
    if (!(share > 0)) continue;
    const std::vector<double> brims = highest_brims(found, i, radius);
    for (std::size_t j = 0; j < found.size(); ++j) {
      const double both = merged_share(found[j].distance, brims[j], radius);
      merged[j] = std::max(both - carried[j], 0.0);
      carried[j] = std::max(carried[j], both);
    }
    const Vec3 mean = mean_normal(found, i, merged, radius),
               centre = found[i].point + found[i].distance * found[i].normal;
    const Vec3 normal = mean.normalized();
    joined.push_back({centre - found[i].distance * normal, normal, found[i].distance, share * mean.norm()});
  }
  found = std::move(joined);
}

}  // namespace clogflow
