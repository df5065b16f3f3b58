#include "coupling/channel_geometry.hpp"

#include "coupling/channel_shape.hpp"
#include "coupling/require.hpp"

namespace clog {
namespace {

// Corners counter-clockwise seen from the fluid.
void add_quad(Walls& walls, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  walls.push_back({{a, b, c}});
  walls.push_back({{a, c, d}});
}

// A piece of floor whose corners (x, y) run counter-clockwise seen from above, and the lid over it.
void add_floor_and_lid(Walls& walls, const std::array<std::array<double, 2>, 4>& p, double height) {
  const auto at = [&](int i, double z) { return Vec3(p[i][0], p[i][1], z); };
  add_quad(walls, at(0, 0), at(1, 0), at(2, 0), at(3, 0));
  add_quad(walls, at(3, height), at(2, height), at(1, height), at(0, height));
}

}  // namespace

Walls channel_walls(const Scene& scene) {
  require(scene.geometry.present, "the scene has no section [geometry]; a channel needs one");
  const auto& g = scene.geometry;
  const double start = channel_start(scene);
  const double bend = -narrowing_length(scene);
  const double end = g.neck_length;
  const double wide = g.channel_width / 2;
  const double neck = g.neck_width / 2;
  Walls walls;

  // Upright walls, first at +y; the ones at -y are their mirror image, which turns them around.
  const std::array<std::array<double, 2>, 4> outline{
      {{start, wide}, {bend, wide}, {0, neck}, {end, neck}}};
  for (std::size_t i = 0; i + 1 < outline.size(); ++i) {
    const auto [xa, ya] = outline[i];
    const auto [xb, yb] = outline[i + 1];
    add_quad(walls, {xa, ya, 0}, {xb, yb, 0}, {xb, yb, g.neck_height}, {xa, ya, g.neck_height});
    add_quad(walls, {xb, -yb, 0}, {xa, -ya, 0}, {xa, -ya, g.neck_height}, {xb, -yb, g.neck_height});
  }

  // Cut along y = +-neck, so that all edges meet whole even when the narrowing is a plane x = 0.
  const auto h = g.neck_height;
  add_floor_and_lid(walls, {{{start, -neck}, {0, -neck}, {0, neck}, {start, neck}}}, h);
  add_floor_and_lid(walls, {{{0, -neck}, {end, -neck}, {end, neck}, {0, neck}}}, h);
  add_floor_and_lid(walls, {{{start, neck}, {0, neck}, {bend, wide}, {start, wide}}}, h);
  add_floor_and_lid(walls, {{{start, -wide}, {bend, -wide}, {0, -neck}, {start, -neck}}}, h);
  return walls;
}

}  // namespace clog
