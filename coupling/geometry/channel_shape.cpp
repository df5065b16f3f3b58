#include "coupling/geometry/channel_shape.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "coupling/base/units.hpp"
#include "coupling/geometry/stl_channel.hpp"
#include "coupling/geometry/wall_sections.hpp"

namespace clogflow {
namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

// Corners of one sharp side; `angle` is that of its narrowing.
std::vector<Vec2> corners(const Geometry& g, double angle, double start) {
  const double wide = g.channel_width / 2, neck = g.neck_width / 2, step = g.step_width / 2;
  const double slope = std::tan(angle);
  std::vector<Vec2> points{{start, wide}};
  if (wide > neck) {
    if (step > 0) {
      const double bend = -(step - neck) / slope, edge = bend - g.step_length;
      points.insert(points.end(), {{edge - (wide - step) / slope, wide}, {edge, step}, {bend, step}});
    } else {
      points.emplace_back(-(wide - neck) / slope, wide);
    }
    points.emplace_back(0, neck);
  }
  points.emplace_back(g.neck_length, neck);
  if (g.expansion_width > 0) {
    const double after = g.expansion_width / 2;
    const double x = g.neck_length + (after - neck) / std::tan(g.expansion_angle);
    points.insert(points.end(), {{x, after}, {x + g.expansion_length, after}});
  }
  return points;
}

// Distance from a corner to where an arc of `radius` touches its two walls.
double tangent_length(double radius, double angle) { return radius * std::tan(angle / 2); }

ChannelSide side(const Geometry& g, double angle, double start) {
  const std::vector<Vec2> points = corners(g, angle, start);
  ChannelSide result;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) result.pieces.push_back({.from = points[i], .to = points[i + 1]});
  if (g.neck_rounding == 0) return result;
  const auto neck = std::ranges::find_if(result.pieces, [](const WallPiece& piece) { return piece.from.x() == 0; });
  const double t = tangent_length(g.neck_rounding, angle);
  const Vec2 along = ((neck - 1)->to - (neck - 1)->from).normalized();
  const WallPiece arc{.from = -t * along + neck->from,
                      .to = {t, neck->from.y()},
                      .radius = g.neck_rounding,
                      .centre = {t, neck->from.y() + g.neck_rounding}};
  (neck - 1)->to = arc.from;
  neck->from = arc.to;
  result.pieces.insert(neck, arc);
  return result;
}

double narrowing(const Geometry& g, double angle) {
  if (g.channel_width <= g.neck_width) return 0;
  return (g.channel_width - g.neck_width) / (2 * std::tan(angle)) + (g.step_width > 0 ? g.step_length : 0);
}

double angle_below(const Geometry& g) { return g.half_angle_below > 0 ? g.half_angle_below : g.half_angle; }

std::string metres(double value) { return format_quantity(value, dimension::length); }

}  // namespace

double WallPiece::distance(double x) const {
  if (is_arc()) return centre.y() - std::sqrt(std::max(0.0, radius * radius - std::pow(x - centre.x(), 2)));
  if (to.x() <= from.x()) return std::min(from.y(), to.y());
  const double share = std::clamp((x - from.x()) / (to.x() - from.x()), 0.0, 1.0);
  return from.y() + share * (to.y() - from.y());
}

double WallPiece::angle_at(const Vec2& end) const {
  const Vec2 along = is_arc() ? Vec2(centre.y() - end.y(), end.x() - centre.x()) : Vec2(to - from);
  return std::atan2(along.y(), along.x());
}

Vec2 WallPiece::middle() const {
  const Vec2 chord = (from + to) / 2;
  return is_arc() ? Vec2(centre + radius * (chord - centre).normalized()) : chord;
}

double WallPiece::length() const {
  if (!is_arc()) return (to - from).norm();
  const Vec2 a = from - centre, b = to - centre;
  return radius * std::atan2(std::abs(cross(a, b)), a.dot(b));
}

double WallPiece::area(double a, double b) const {
  if (!is_arc()) return (b - a) * distance((a + b) / 2);
  // Below a circle: integral of centre.y - sqrt(R^2 - u^2).
  const auto integral = [this](double x) {
    const double u = std::clamp((x - centre.x()) / radius, -1.0, 1.0);
    return radius * radius / 2 * (u * std::sqrt(1 - u * u) + std::asin(u));
  };
  return (b - a) * centre.y() - (integral(b) - integral(a));
}

double ChannelSide::distance(double x) const {
  if (x < pieces.front().from.x()) return pieces.front().from.y();
  double nearest = pieces.back().to.y();
  bool found = false;
  for (const WallPiece& piece : pieces) {
    if (x < piece.from.x() || x > piece.to.x()) continue;
    nearest = found ? std::min(nearest, piece.distance(x)) : piece.distance(x);
    found = true;
  }
  return nearest;
}

ChannelShape channel_shape(const Geometry& geometry) {
  const double start = channel_start(geometry);
  const double above = geometry.half_angle, below = angle_below(geometry);
  return {.upper = side(geometry, above, start), .lower = side(geometry, below, start), .symmetric = above == below};
}

std::string shape_fault(const Geometry& g) {
  const double wide = g.channel_width, neck = g.neck_width;
  const auto fault = [](const char* key, double value, const std::string& rule) {
    return fmt::format("geometry.{} = {} ({})", key, metres(value), rule);
  };
  const bool narrows = wide > neck;
  if (!narrows && (g.neck_rounding > 0 || g.step_width > 0 || g.half_angle_below > 0))
    return fault("channel_width", wide,
                 "must exceed neck_width = " + metres(neck) +
                     ", or there is no narrowing for neck_rounding, step_width or half_angle_below");
  if (g.step_width > 0 && (g.step_width <= neck || g.step_width >= wide))
    return fault("step_width", g.step_width,
                 "must lie between neck_width = " + metres(neck) + " and channel_width = " + metres(wide));
  if (g.step_width > 0 && g.step_length == 0)
    return fault("step_width", g.step_width, "needs geometry.step_length too");
  if (g.step_width == 0 && g.step_length > 0)
    return fault("step_length", g.step_length, "needs geometry.step_width too");
  if (g.step_width > 0 && g.half_angle_below > 0)
    return fault("step_width", g.step_width,
                 "two steps with different walls cannot be meshed: leave out half_angle_below");
  if (g.expansion_width > 0 && g.expansion_width <= neck)
    return fault("expansion_width", g.expansion_width, "must exceed neck_width = " + metres(neck));
  if (g.neck_rounding > 0) {
    const double foot = g.step_width > 0 ? g.step_width : wide;
    for (const double angle : {g.half_angle, angle_below(g)}) {
      const double t = tangent_length(g.neck_rounding, angle);
      // A tenth of each wall stays straight, so that it can be meshed.
      const double room = 0.9 * std::min((foot - neck) / 2 / std::sin(angle), g.neck_length);
      if (t > room)
        return fault("neck_rounding", g.neck_rounding,
                     "the arc does not fit between the slanted wall and the neck; at most " +
                         metres(room / std::tan(angle / 2)));
    }
  }
  return {};
}

double narrowing_length(const Geometry& g) {
  if (is_stl_channel(g)) return -(g.inlet_position + g.channel_length);
  return std::max(narrowing(g, g.half_angle), narrowing(g, angle_below(g)));
}

double solved_length(const Geometry& geometry) {
  constexpr double shortest_widths = 0.5;
  const double widest = std::max(geometry.channel_width, geometry.neck_height);
  return std::clamp(geometry.channel_length, shortest_widths * widest, development_widths * widest);
}

double channel_start(const Geometry& geometry) { return -(narrowing_length(geometry) + geometry.channel_length); }

double channel_end(const Geometry& geometry) {
  if (is_stl_channel(geometry)) return geometry.outlet_position;
  return corners(geometry, geometry.half_angle, 0).back().x();
}

double neck_start(const Geometry& g) {
  if (is_stl_channel(g)) return 0;
  return tangent_length(g.neck_rounding, std::max(g.half_angle, angle_below(g)));
}

double channel_flow_rate(const Geometry& g, double mean_velocity) {
  return g.inlet_area > 0 ? mean_velocity * g.inlet_area : mean_velocity * g.channel_width * g.neck_height;
}

double neck_section(const Geometry& g) { return g.neck_area > 0 ? g.neck_area : g.neck_width * g.neck_height; }

double neck_mean_velocity(const Geometry& geometry, double mean_velocity) {
  if (geometry.neck_area > 0) return channel_flow_rate(geometry, mean_velocity) / geometry.neck_area;
  return mean_velocity * geometry.channel_width / geometry.neck_width;
}

double channel_volume(const Geometry& geometry, double from, double to) {
  if (is_stl_channel(geometry)) return volume_between(read_stl_channel(geometry)->walls, from, to);
  const ChannelShape shape = channel_shape(geometry);
  double area = 0;
  for (const ChannelSide* wall : {&shape.upper, &shape.lower}) {
    for (const WallPiece& piece : wall->pieces) {
      const double a = std::max(from, piece.from.x()), b = std::min(to, piece.to.x());
      if (a < b) area += piece.area(a, b);
    }
  }
  return area * geometry.neck_height;
}

}  // namespace clogflow
