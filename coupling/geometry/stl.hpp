// Walls from an STL file, text or binary, and text files of named parts.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "coupling/geometry/walls.hpp"

namespace clogflow {

/// Reads the triangles of an STL file; coordinates are taken as metres. The order of the corners
/// decides the side of the fluid, the stored normals are not used.
/// \throws Error if the file cannot be read, is cut short, holds no triangle or a number that is not
///         finite
Walls read_stl(const std::filesystem::path& file);

/// A part of an STL file: the text between `solid` and `endsolid`, or a whole binary file.
struct StlSolid {
  std::string name;  ///< empty where the file gives none
  Walls triangles;
};

/// The same by parts, in the order of the file.
std::vector<StlSolid> read_stl_solids(const std::filesystem::path& file);

/// Text of an STL file. \param unit  length that the file counts in [m]
std::string stl_text(const std::vector<StlSolid>& solids, double unit);

}  // namespace clogflow
