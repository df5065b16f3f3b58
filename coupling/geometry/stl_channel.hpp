// A channel of any shape: an STL file whose parts name the openings.
#pragma once

#include <memory>
#include <string>

#include "coupling/geometry/geometry.hpp"
#include "coupling/geometry/walls.hpp"

namespace clogflow {

/// A round inlet: a polygon of many equal sides.
struct RoundInlet {
  double diameter = 0;  ///< of the largest circle in it [m]; 0: the inlet is a rectangle
  double area = 0;      ///< [m2]
};

/// The flow runs along x: the part `inlet` is a rectangle or a circle in the plane of the smallest x, |y| <=
/// width / 2 and 0 <= z <= height, behind which the walls stay straight for a while; the part
/// `outlet` lies in the plane of the largest x; all other parts are walls. The neck's entrance is at
/// x = 0; there may be several side by side.
struct StlChannel {
  Walls walls;           ///< normals into the fluid [m]
  double inlet, outlet;  ///< x [m]
  double width, height;  ///< of the inlet [m]
  double straight_end;   ///< x where the first wall leaves the direction of x [m]
  double neck_width;     ///< y extent just behind x = 0, of several necks of the widest [m]
  double neck_length;    ///< from x = 0 to where the section grows by 1 %, or to the outlet [m]
  RoundInlet round;
  double neck_area = 0;  ///< of all necks just behind x = 0, where neck_width x height is not it [m2]; else 0
  std::string note;      ///< one line on facets that are left out, or empty
};

/// Content hash of the scene's file: walls decide a flow by their content, wherever they lie.
std::string stl_content_hash(const Geometry& geometry);

/// Whether the scene's channel comes from such a file, and has been measured.
bool is_stl_channel(const Geometry& geometry);

/// Reads the scene's file, once as long as scenes ask for the same one, and checks it: closed, each edge between two
/// triangles that are turned alike (all normals into the fluid or all out of it), openings named, flat and in their
/// place. \throws Error with the file, what is wrong and where
std::shared_ptr<const StlChannel> read_stl_channel(const Geometry& geometry);

/// The parametric channel as such a file's parts, with inlet and outlet.
/// \throws Error on a scene without a parametric channel
std::string channel_stl(const Geometry& geometry, double unit);

}  // namespace clogflow
