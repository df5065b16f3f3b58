// The parametric channel along x: where it starts, how wide it is, what it holds.
#pragma once

#include <algorithm>
#include <cmath>

#include "coupling/scene.hpp"

namespace clog {

/// Length along x over which the channel narrows, (W - D) / (2 tan(angle)) [m].
inline double narrowing_length(const Scene& scene) {
  const auto& g = scene.geometry;
  return (g.channel_width - g.neck_width) / (2 * std::tan(g.half_angle));
}

/// x of the channel's inlet; the neck's entrance is at x = 0 [m].
inline double channel_start(const Scene& scene) {
  return -(narrowing_length(scene) + scene.geometry.channel_length);
}

/// Width (extent along y) at x [m].
inline double channel_width_at(const Scene& scene, double x) {
  const auto& g = scene.geometry;
  return std::clamp(g.neck_width - 2 * x * std::tan(g.half_angle), g.neck_width, g.channel_width);
}

/// Volume of the channel between two planes x = from < to, both at or upstream of the neck's
/// entrance [m3]. The width is linear in pieces, so the midpoint of each piece is exact.
inline double channel_volume(const Scene& scene, double from, double to) {
  const double bend = std::clamp(-narrowing_length(scene), from, to);
  const auto piece = [&](double a, double b) {
    return (b - a) * channel_width_at(scene, (a + b) / 2) * scene.geometry.neck_height;
  };
  return piece(from, bend) + piece(bend, to);
}

}  // namespace clog
