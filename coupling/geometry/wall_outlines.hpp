// Where a plane cuts the walls, as lines from corner to corner; and the openings between them.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "coupling/geometry/walls.hpp"

namespace clogflow {

/// A line along which a plane cuts the walls, with the fluid on its left.
struct WallOutline {
  std::vector<Eigen::Vector2d> corners;  ///< (y, z) across the flow, (x, y) along it [m]
  bool closed = false;                   ///< the last corner is joined to the first

  double area() const;                               ///< of the fluid within, < 0 around an obstacle [m2]
  bool holds(const Eigen::Vector2d& at) const;       ///< whether a point lies within a closed line
  double distance(const Eigen::Vector2d& at) const;  ///< of a point from the line [m]
};

/// Cut with the plane of an x, in (y, z). Walls whose triangles share their corners bit for bit give whole lines.
std::vector<WallOutline> cut_across(const Walls& walls, double x);

/// Cut with the plane of a z, in (x, y): what a picture from above shows.
std::vector<WallOutline> cut_along(const Walls& walls, double z);

/// The openings that the walls leave at x, in order of y, then z, of their middles: the necks of a channel that has
/// several side by side. An obstacle within an opening makes no other of it.
std::vector<WallOutline> openings_at(const Walls& walls, double x);

/// Which opening a place belongs to: the one that holds it, or the nearest. \param openings  at least one
int opening_of(const std::vector<WallOutline>& openings, const Eigen::Vector2d& at);

/// The fluid as closed lines: open ones are joined straight across where the channel ends.
std::vector<WallOutline> closed_outlines(std::vector<WallOutline> lines);

}  // namespace clogflow
