// The outline of the parametric channel in the x-y plane: the one place that knows its shape.
// Walls, mesh, solid mask and volumes follow from it.
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "coupling/geometry/geometry.hpp"

namespace clogflow {

using Vec2 = Eigen::Vector2d;

/// A piece of side wall, x along the flow and y > 0 the distance from the axis: straight, or an arc
/// around a centre inside the wall.
struct WallPiece {
  Vec2 from, to;      ///< [m], from.x <= to.x
  double radius = 0;  ///< of an arc; 0: straight [m]
  Vec2 centre{0, 0};  ///< of an arc [m]

  bool is_arc() const { return radius > 0; }
  /// y at an x between from and to [m]
  double distance(double x) const;
  /// Angle of the wall from the flow axis where the piece begins or ends, < 0 where it narrows
  /// [rad]
  double angle_at(const Vec2& end) const;
  /// Middle of the piece [m]
  Vec2 middle() const;
  double length() const;  ///< [m]
  /// Area between the piece and the axis for a <= x <= b inside the piece [m2]
  double area(double a, double b) const;
};

/// One side wall from inlet to outlet, without a gap.
struct ChannelSide {
  std::vector<WallPiece> pieces;

  /// Distance of the wall from the axis at x; where it steps, the smaller one [m]
  double distance(double x) const;
};

struct ChannelShape {
  ChannelSide upper, lower;  ///< at y > 0, and at y < 0 mirrored
  bool symmetric;            ///< both are the same

  double start() const { return upper.pieces.front().from.x(); }  ///< x of the inlet [m]
  double end() const { return upper.pieces.back().to.x(); }       ///< x of the outlet [m]
  /// Width (extent along y) at x [m]
  double width(double x) const { return upper.distance(x) + lower.distance(x); }
};

/// The shape of the scene's [geometry]; it must have passed check_shape.
ChannelShape channel_shape(const Geometry& geometry);

/// What makes the shape impossible, in words with the key and its value; empty if nothing does.
std::string shape_fault(const Geometry& geometry);

/// Length along x over which the channel narrows; of two different sides the longer one [m].
double narrowing_length(const Geometry& geometry);

/// Length before the narrowing, or before a step out to a wider channel, over which a flow develops, in widths:
/// disturbances die out like exp(-2 pi x / width), which leaves 4e-4.
inline constexpr double development_widths = 1.25;

/// How much of the channel before the narrowing is solved: all that the neck disturbs, at most. A longer channel has
/// the same flow, developed before that; of a channel shorter than half a width that half is solved. For channels
/// by keys, not from a file. [m]
double solved_length(const Geometry& geometry);

/// x of the channel's inlet; the (unrounded) neck's entrance is at x = 0 [m].
double channel_start(const Geometry& geometry);

/// x of the channel's outlet: the end of the neck, or of the expansion after it [m].
double channel_end(const Geometry& geometry);

/// x from which the neck has its width: 0, or the end of its rounded entrance [m].
double neck_start(const Geometry& geometry);

/// What the channel carries [m3/s].
/// \param mean_velocity  over the inlet [m/s]
double channel_flow_rate(const Geometry& geometry, double mean_velocity);

/// Cross-section of the neck, or of all necks side by side [m2].
double neck_section(const Geometry& geometry);

/// Mean velocity in the neck: the channel's flow rate over the neck's cross-section [m/s].
double neck_mean_velocity(const Geometry& geometry, double mean_velocity);

/// Volume of the channel between two planes x = from < to [m3].
double channel_volume(const Geometry& geometry, double from, double to);

}  // namespace clogflow
