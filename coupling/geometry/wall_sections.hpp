// Sections and volumes of a channel whose walls are triangles, open along x = const.
#pragma once

#include <vector>

#include "coupling/geometry/walls.hpp"

namespace clogflow {

/// Cut of the walls with a plane x = const.
struct WallSection {
  double area = 0;                                 ///< of the fluid in the plane [m2]
  double y_min = 0, y_max = 0;                     ///< [m]
  double z_min = 0, z_max = 0;                     ///< [m]
  double width() const { return y_max - y_min; }   ///< [m]
  double height() const { return z_max - z_min; }  ///< [m]
};

/// Section at x, which should not be the x of a corner; all zero where there is no wall.
WallSection section_at(const Walls& walls, double x);

/// The same at several x in ascending order.
std::vector<WallSection> sections_at(const Walls& walls, const std::vector<double>& places);

/// Length of the neck, which begins at x = 0: up to where the section is more than 1 % larger than just behind x =
/// from, or to the outlet [m].
double neck_length(const Walls& walls, double from, double outlet);

/// Volume of the fluid between two planes x = from < to, from the walls alone: openings that lie in
/// planes of constant x do not count in the integral of y over the surface [m3].
double volume_between(const Walls& walls, double from, double to);

/// x up to which, from the upstream end on, all walls are parallel to x [m].
double straight_until(const Walls& walls);

/// For each z in ascending order whether (x, y, z) lies in the fluid, by counting walls below it.
std::vector<bool> inside_along_z(const Walls& walls, double x, double y, const std::vector<double>& z);

}  // namespace clogflow
