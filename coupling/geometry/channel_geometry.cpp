#include "coupling/geometry/channel_geometry.hpp"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "coupling/base/require.hpp"
#include "coupling/geometry/polygon.hpp"

namespace clogflow {
namespace {

// An arc becomes flat pieces that turn by at most this: they are off by 0.001 radii. [rad]
constexpr double facet_turn = 5 * std::numbers::pi / 180;

// Corners of one side from inlet to outlet.
std::vector<Vec2> facets(const ChannelSide& side) {
  std::vector<Vec2> points{side.pieces.front().from};
  for (const WallPiece& piece : side.pieces) {
    const int count = piece.is_arc() ? static_cast<int>(std::ceil(piece.length() / piece.radius / facet_turn)) : 1;
    const Vec2 a = piece.from - piece.centre;
    for (int i = 1; i < count; ++i) {
      const double angle = i * piece.length() / piece.radius / count;
      points.push_back(piece.centre + Eigen::Rotation2Dd(angle) * a);
    }
    points.push_back(piece.to);
  }
  return points;
}

// The wall that stands on the edge a-b of the floor, which has the fluid on its left.
void add_upright(Walls& walls, const Vec2& a, const Vec2& b, double height) {
  const Vec3 low_a(a.x(), a.y(), 0), low_b(b.x(), b.y(), 0);
  const Vec3 high_a(a.x(), a.y(), height), high_b(b.x(), b.y(), height);
  walls.push_back({{low_b, low_a, high_a}});
  walls.push_back({{low_b, high_a, high_b}});
}

}  // namespace

ChannelOutline channel_outline(const Geometry& geometry) {
  const ChannelShape shape = channel_shape(geometry);
  ChannelOutline outline{facets(shape.upper), facets(shape.lower)};
  for (Vec2& point : outline.lower) point.y() = -point.y();
  return outline;
}

Walls channel_walls(const Geometry& geometry) {
  require(geometry.present, "the scene has no section [geometry]; a channel needs one");
  const double height = geometry.neck_height;
  const ChannelOutline sides = channel_outline(geometry);
  // Counter-clockwise: below from inlet to outlet, above back again.
  std::vector<Vec2> outline = sides.lower;
  outline.insert(outline.end(), sides.upper.rbegin(), sides.upper.rend());

  Walls walls;
  for (std::size_t i = 0; i + 1 < outline.size(); ++i)
    if (i + 1 != sides.lower.size()) add_upright(walls, outline[i], outline[i + 1], height);
  for (const auto& [a, b, c] : triangulate(outline)) {
    const auto at = [&](int i, double z) { return Vec3(outline[i].x(), outline[i].y(), z); };
    walls.push_back({{at(a, 0), at(b, 0), at(c, 0)}});
    walls.push_back({{at(c, height), at(b, height), at(a, height)}});
  }
  return walls;
}

}  // namespace clogflow
