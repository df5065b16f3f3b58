// The surface of a scene's STL file: its corners joined within the scene's tolerance, what says
// nothing left out.
#pragma once

#include <string>
#include <vector>

#include "coupling/geometry/geometry.hpp"
#include "coupling/geometry/wall_mesh.hpp"

namespace clogflow {

struct StlSurface {
  JoinedWalls joined;
  WallMesh mesh;              ///< the same cut at hanging corners
  std::vector<WallRim> rims;  ///< where it is open, the shortest first
  double tolerance;           ///< [m]
  std::string note;           ///< one line on facets that are left out, or empty
};

/// Length that the scene's file counts in [m].
double stl_unit(const Geometry& geometry);

/// \param walls  of the file [m]
/// \throws Error with the file's name if the tolerance is larger than facets, leaves none or opens
/// the shape
StlSurface stl_surface(Walls walls, const Geometry& geometry);

/// Corners of walls that the scene's file, or its keys, made are one within this [m].
double weld_length(const Walls& walls, const Geometry& geometry);

/// "2.2e-05 x 1e-04 x 0.0001 m, counted in units of 1e-06 m": what tells a wrong unit.
std::string extent_words(const Walls& walls, const Geometry& geometry);

}  // namespace clogflow
