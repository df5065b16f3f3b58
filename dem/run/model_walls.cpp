#include "dem/run/model_walls.hpp"

#include <algorithm>

#include "coupling/base/require.hpp"
#include "coupling/geometry/channel_geometry.hpp"
#include "coupling/geometry/channel_shape.hpp"
#include "coupling/geometry/stl.hpp"
#include "coupling/geometry/stl_channel.hpp"
#include "coupling/geometry/stl_surface.hpp"
#include "coupling/geometry/wall_sections.hpp"

namespace clogflow {

namespace {

/// A rectangle as two triangles; corners in order around it, counter-clockwise from the fluid.
void add_rectangle(Walls& walls, const std::array<Vec3, 4>& c) {
  walls.push_back({{c[0], c[1], c[2]}});
  walls.push_back({{c[0], c[2], c[3]}});
}

/// A wall across the channel at x whose normal points along `facing` (+1 or -1).
Walls cross_wall(double x, double width, double height, int facing) {
  const double y = width / 2;
  std::array<Vec3, 4> corner{Vec3{x, -y, 0}, Vec3{x, y, 0}, Vec3{x, y, height}, Vec3{x, -y, height}};
  if (facing < 0) std::swap(corner[1], corner[3]);
  Walls walls;
  add_rectangle(walls, corner);
  return walls;
}

Walls box_walls(const Vec3& low, const Vec3& high) {
  Walls walls;
  for (int a = 0; a < 3; ++a)
    for (const bool upper : {false, true}) {
      const int b = (a + 1) % 3, c = (a + 2) % 3;
      std::array<Vec3, 4> corner;
      for (Vec3& v : corner) v[a] = upper ? high[a] : low[a];
      const double lb = low[b], hb = high[b], lc = low[c], hc = high[c];
      corner[0][b] = lb, corner[1][b] = hb, corner[2][b] = hb, corner[3][b] = lb;
      corner[0][c] = lc, corner[1][c] = lc, corner[2][c] = hc, corner[3][c] = hc;
      if (upper) std::swap(corner[1], corner[3]);
      add_rectangle(walls, corner);
    }
  return walls;
}

void enclose(Domain& domain, const Walls& walls) {
  domain.low = Vec3::Constant(1e300), domain.high = Vec3::Constant(-1e300);
  for (const Triangle& t : walls)
    for (const Vec3& corner : t.corner)
      domain.low = domain.low.cwiseMin(corner), domain.high = domain.high.cwiseMax(corner);
}

/// What a file's walls are worth a word for, or empty.
std::string note_on(const StlSurface& surface, const std::string& file) {
  std::string note = surface.note.empty() ? "" : file + ": " + surface.note;
  if (surface.rims.empty()) return note;
  const WallRim& rim = surface.rims[0];
  return note + (note.empty() ? "" : "; ") +
         fmt::format(
             "{}: the walls are open along {} rim{}, the shortest {:.3g} m around at ({:.4g}, {:.4g}, "
             "{:.4g}) m: a particle that leaves the walls' extent there ends the run",
             file, surface.rims.size(), surface.rims.size() > 1 ? "s" : "", rim.length, rim.place.x, rim.place.y,
             rim.place.z);
}

/// Walls of more particle diameters than this are most likely counted in another unit.
constexpr double unlikely_extent = 1e5;

void check_extent(const Walls& walls, const Scene& scene, std::string& note) {
  const double extent = largest_extent(walls), diameter = scene.particles.diameter;
  const std::string words = fmt::format("the walls of geometry.stl = {} are {}: is geometry.stl_unit right?",
                                        scene.geometry.stl, extent_words(walls, scene.geometry));
  require(diameter < extent, "particles.diameter = {:.3g} m (larger than all walls; {})", diameter, words);
  if (extent > unlikely_extent * diameter)
    note += fmt::format("{}{:.2g} particle diameters; {}", note.empty() ? "" : "; ", extent / diameter, words);
}

/// The walls of a laboratory from the scene's file.
Walls file_walls(const Scene& scene, std::string& note) {
  Walls walls = read_stl(scene.geometry.stl);
  for (Triangle& t : walls)
    for (Vec3& corner : t.corner) corner *= stl_unit(scene.geometry);
  StlSurface surface = stl_surface(std::move(walls), scene.geometry);
  note = note_on(surface, scene.geometry.stl);
  surface.mesh = {};
  walls = surface.joined.walls();
  check_extent(walls, scene, note);
  return walls;
}

/// Several necks lie apart: the gate spans all that is open behind x = 0.
double gate_width(const Geometry& g, const Walls& channel) {
  if (g.neck_area == 0) return g.neck_width;
  const WallSection section = section_at(channel, 1e-3 * g.neck_length);
  return 2 * std::max(-section.y_min, section.y_max);
}

/// In a laboratory, where a plane at 0 is none.
void count_at(Model& model, double plane) {
  if (plane == 0) return;
  require(plane > model.domain.low.x && plane < model.domain.high.x,
          "passages.plane = {:.6g} m (must be within the walls, from x = {:.6g} to {:.6g} m)", plane,
          model.domain.low.x, model.domain.high.x);
  model.domain.passage = plane;
}

}  // namespace

bool is_channel(const Scene& s) { return s.geometry.present && (s.geometry.stl.empty() || is_stl_channel(s.geometry)); }

Walls open_channel(const Scene& s, const FlowGrid* flow, std::string& note) {
  // A flow serves channels of other lengths; walls from a file lie in it, whatever became of the file.
  if (!is_stl_channel(s.geometry)) return channel_walls(s.geometry);
  if (flow) return flow->walls;
  const auto measured = read_stl_channel(s.geometry);
  note = measured->note;
  return measured->walls;
}

void build_walls(Model& model, const FlowGrid* flow) {
  const Scene& s = model.scene;
  if (s.box.present) {
    model.walls = box_walls(Vec3(s.box.min.data()), Vec3(s.box.max.data()));
    enclose(model.domain, model.walls);
    count_at(model, s.passages.plane);
  }
  if (!s.geometry.present) return;
  if (is_channel(s)) {
    const Walls channel = open_channel(s, flow, model.walls_note);
    model.walls.insert(model.walls.end(), channel.begin(), channel.end());
    const Walls end = cross_wall(channel_start(s.geometry), s.geometry.channel_width, s.geometry.neck_height, 1);
    model.walls.insert(model.walls.end(), end.begin(), end.end());
    model.gate = cross_wall(neck_start(s.geometry), gate_width(s.geometry, channel), s.geometry.neck_height, -1);
    if (is_stl_channel(s.geometry)) model.necks = openings_at(channel, s.passages.plane);
    if (model.necks.size() == 1) model.necks.clear();
    enclose(model.domain, model.walls);
    model.domain.outlet = channel_end(s.geometry);
    model.domain.passage = s.passages.plane;
  } else {
    const Walls stl = file_walls(s, model.walls_note);
    model.walls.insert(model.walls.end(), stl.begin(), stl.end());
    enclose(model.domain, model.walls);
    if (flow) model.domain.outlet = model.domain.high.x;
    count_at(model, s.passages.plane);
  }
}

}  // namespace clogflow
