#include "coupling/geometry/stl_surface.hpp"

#include "coupling/base/require.hpp"

namespace clogflow {
namespace {

// What is open with a tolerance and closed without one was opened by it.
void refuse_opening(const StlSurface& surface, const Walls& walls, const std::string& file) {
  if (surface.rims.empty() || surface.joined.left_out.without_area == 0) return;
  require(open_rims(join_walls(walls, 0)).size() >= surface.rims.size(),
          "{}: {}; that opens the surface: give geometry.stl_tolerance a smaller value", file, surface.note);
}

// Frees walls that are not needed again: those of ten million facets are 0.7 GB.
StlSurface joined_surface(Walls& walls, const Geometry& geometry) {
  StlSurface surface{.joined = {}, .mesh = {}, .rims = {}, .tolerance = weld_length(walls, geometry), .note = {}};
  surface.joined = join_corners(walls, surface.tolerance);
  if (surface.joined.left_out.count() > 0)
    surface.note =
        fmt::format("{} (geometry.stl_tolerance = {:.3g} m)", surface.joined.left_out.words(), surface.tolerance);
  require(!surface.joined.source.empty(), "{}: none is left", surface.note);
  if (surface.joined.left_out.without_area == 0) Walls().swap(walls);
  surface.mesh = cut_edges(surface.joined, surface.tolerance);
  surface.rims = open_rims(surface.mesh);
  return surface;
}

}  // namespace

double stl_unit(const Geometry& geometry) { return geometry.stl_unit > 0 ? geometry.stl_unit : 1; }

StlSurface stl_surface(Walls walls, const Geometry& geometry) {
  const std::string file = "geometry.stl = " + geometry.stl;
  try {
    StlSurface surface = joined_surface(walls, geometry);
    refuse_opening(surface, walls, file);
    return surface;
  } catch (const Error& error) {
    const std::string text = error.what();
    throw Error(text.starts_with(file) ? text : file + ": " + text);
  }
}

double weld_length(const Walls& walls, const Geometry& geometry) {
  return geometry.stl_tolerance >= 0 ? geometry.stl_tolerance : weld_length(walls);
}

std::string extent_words(const Walls& walls, const Geometry& geometry) {
  Vec3 low = walls.at(0).corner[0], high = low;
  for (const Triangle& t : walls)
    for (const Vec3& corner : t.corner) low = low.cwiseMin(corner), high = high.cwiseMax(corner);
  const Vec3 size = high - low;
  return fmt::format("{:.3g} x {:.3g} x {:.3g} m, counted in units of {:.3g} m", size.x, size.y, size.z,
                     stl_unit(geometry));
}

}  // namespace clogflow
