// The channel as a scene describes it: by numbers, or by a file of walls.
#pragma once

#include <string>

namespace clogflow {

/// Section [geometry] of a scene, one member per key.
struct Geometry {
  bool present = false;
  double neck_width = 0;        ///< y extent of the neck, D [m]
  double neck_height = 0;       ///< z extent of neck and channel [m]; default neck_width
  double channel_width = 0;     ///< y extent of the wide channel [m]; default 4 neck_width
  double channel_length = 0;    ///< straight part upstream of the narrowing [m]; default 10 neck_width
  double neck_length = 0;       ///< straight part of the neck [m]; default neck_width
  double half_angle = 0;        ///< of the narrowing, from the flow axis [rad]
  double half_angle_below = 0;  ///< of its wall at y < 0 [rad]; 0: half_angle
  double neck_rounding = 0;     ///< radius of the neck's entrance [m]; 0: sharp
  double step_width = 0;        ///< y extent of a straight part between two narrowings [m]; 0: none
  double step_length = 0;       ///< its length [m]
  double expansion_width = 0;   ///< y extent of the channel after the neck [m]; 0: none
  double expansion_length = 0;  ///< its straight part [m]; default expansion_width
  double expansion_angle = 0;   ///< of its walls, from the flow axis [rad]; default half_angle
  std::string stl;              ///< walls from this file instead of the shape above; empty: none
  double stl_unit = 0;          ///< length that the file counts in [m]; 0: metres
  double stl_tolerance = -1;    ///< between corners that are one [m]; < 0: a share of the extent
  std::string stl_content;      ///< content hash of the file of a channel; empty: not a channel
  double inlet_position = 0;    ///< x of the inlet of a channel from a file [m]; 0: none
  double outlet_position = 0;   ///< x of its outlet [m]; 0: none
  double inlet_diameter = 0;    ///< of the largest circle within a round inlet [m]; 0: the inlet is a rectangle
  double inlet_area = 0;        ///< of a round inlet [m2]; 0: a rectangle
  double neck_area = 0;         ///< of all necks just behind x = 0 [m2]; 0: neck_width x neck_height
};

}  // namespace clogflow
