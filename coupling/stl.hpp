// Walls from an STL file, text or binary.
#pragma once

#include <filesystem>

#include "coupling/walls.hpp"

namespace clog {

/// Reads the triangles of an STL file; coordinates are taken as metres. The order of the corners
/// decides the side of the fluid, the stored normals are not used.
/// \throws Error if the file cannot be read, is cut short, holds no triangle or a number that is not
///         finite
Walls read_stl(const std::filesystem::path& file);

}  // namespace clog
