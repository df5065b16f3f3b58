#include "coupling/stl_channel.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <vector>

#include "coupling/channel_geometry.hpp"
#include "coupling/content_hash.hpp"
#include "coupling/require.hpp"
#include "coupling/stl.hpp"
#include "coupling/units.hpp"
#include "coupling/wall_mesh.hpp"
#include "coupling/wall_sections.hpp"

namespace clog {
namespace {

// Files hold few digits: lengths closer than this share of the channel's length are the same.
constexpr double same = 1e-5;

std::string place_text(const Vec3& p) {
  return fmt::format("({:.4g}, {:.4g}, {:.4g}) m", p.x(), p.y(), p.z());
}

// Each edge must belong to two triangles which run along it in opposite directions.
void require_closed(const WallMesh& mesh, const std::string& file) {
  const std::vector<WallRim> rims = open_rims(mesh);
  require(rims.empty(),
          "{}: the surface is not closed (a hole of {:.3g} m around at {}); close it, inlet and outlet "
          "included",
          file, rims.empty() ? 0 : rims[0].length, rims.empty() ? "" : place_text(rims[0].place));
  std::map<std::array<int, 2>, int> along;
  for (const auto& corner : mesh.corner)
    for (int k = 0; k < 3; ++k) ++along[{corner[k], corner[(k + 1) % 3]}];
  for (std::size_t t = 0; t < mesh.corner.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int a = mesh.corner[t][k], b = mesh.corner[t][(k + 1) % 3];
      const auto back = along.find({b, a});
      const int there = along[{a, b}], other = back == along.end() ? 0 : back->second;
      const std::string at = place_text(mesh.triangles[t].corner[k]);
      require(there + other == 2, "{}: {} triangles meet in the edge at {} (must be 2)", file,
              there + other, at);
      require(there == 1, "{}: the triangles on the two sides of the edge at {} are turned differently "
              "(corners in opposite order); turn one of them", file, at);
    }
}

struct Box {
  Vec3 low = Vec3::Constant(1e300), high = Vec3::Constant(-1e300);
  void add(const Walls& walls) {
    for (const Triangle& t : walls)
      for (const Vec3& corner : t.corner) low = low.cwiseMin(corner), high = high.cwiseMax(corner);
  }
};

double area(const Walls& walls) {
  double sum = 0;
  for (const Triangle& t : walls)
    sum += (t.corner[1] - t.corner[0]).cross(t.corner[2] - t.corner[0]).norm() / 2;
  return sum;
}

// Twice six times the signed volume is positive for normals that point out.
double volume(const Walls& surface) {
  double six = 0;
  for (const Triangle& t : surface) six += t.corner[0].dot(t.corner[1].cross(t.corner[2]));
  return six / 6;
}

class Reader {
public:
  Reader(const Scene& scene) : file_("geometry.stl = " + scene.geometry.stl) {
    const double unit = stl_unit(scene);
    std::string names;
    for (const StlSolid& solid : read_stl_solids(scene.geometry.stl)) {
      names += (names.empty() ? "" : ", ") + (solid.name.empty() ? "one without a name" : solid.name);
      Walls& part = solid.name == "inlet" ? inlet_ : solid.name == "outlet" ? outlet_ : walls_;
      for (Triangle t : solid.triangles) {
        for (Vec3& corner : t.corner) corner *= unit;
        part.push_back(t);
      }
    }
    for (const auto& [part, name] : {std::pair(&inlet_, "inlet"), {&outlet_, "outlet"}, {&walls_, "walls"}})
      require(!part->empty(), "{}: holds no part named {} (its parts: {}); write \"solid {}\" before "
              "those facets, in a text file", file_, name, names, name);
  }

  StlChannel channel() {
    Walls all = walls_;
    all.insert(all.end(), inlet_.begin(), inlet_.end());
    all.insert(all.end(), outlet_.begin(), outlet_.end());
    try {
      require_closed(join_walls(all), file_);
    } catch (const Error& error) {
      const std::string text = error.what();
      throw Error(text.starts_with(file_) ? text : file_ + ": " + text);
    }
    if (volume(all) > 0)
      for (Triangle& t : walls_) std::swap(t.corner[1], t.corner[2]);
    Box box;
    box.add(all);
    return measured(box);
  }

private:
  void require_flat(const Walls& part, const char* name, double x, double tolerance) const {
    for (const Triangle& t : part)
      for (const Vec3& corner : t.corner)
        require(std::abs(corner.x() - x) < tolerance,
                "{}: the {} has a corner at x = {:.6g} m (all must lie in the plane x = {:.6g} m, the "
                "{} of the surface: the flow runs along x)",
                file_, name, corner.x(), x, name == std::string("inlet") ? "upstream end" : "downstream end");
  }

  StlChannel measured(const Box& box) const {
    const double tolerance = same * (box.high.x() - box.low.x());
    require_flat(inlet_, "inlet", box.low.x(), tolerance);
    require_flat(outlet_, "outlet", box.high.x(), tolerance);
    Box in;
    in.add(inlet_);
    const Vec3 size = in.high - in.low;
    require(std::abs(area(inlet_) / (size.y() * size.z()) - 1) < 1e-4 &&
                std::abs(in.low.y() + in.high.y()) < tolerance && std::abs(in.low.z()) < tolerance,
            "{}: the inlet fills {:.4g} of y from {:.4g} to {:.4g} m, z from {:.4g} to {:.4g} m (must be a whole "
            "rectangle with y = 0 in its middle and z = 0 at its floor)",
            file_, area(inlet_) / (size.y() * size.z()), in.low.y(), in.high.y(), in.low.z(), in.high.z());
    const double straight_end = straight_until(walls_);
    require(box.low.x() < 0 && box.high.x() > 0, "{}: reaches from x = {:.4g} to {:.4g} m (x = 0 must lie "
            "between, at the neck's entrance)", file_, box.low.x(), box.high.x());
    require(straight_end > box.low.x() + tolerance && straight_end < tolerance,
            "{}: its walls are parallel to x up to {:.4g} m (they must be between the inlet, x = {:.4g} m, and some "
            "place before the neck, x = 0: there particles enter and the flow is developed)",
            file_, straight_end, box.low.x());
    const double neck = section_at(walls_, 2 * tolerance).width();
    return {.walls = walls_, .inlet = box.low.x(), .outlet = box.high.x(), .width = size.y(),
            .height = size.z(), .straight_end = std::min(straight_end, 0.0), .neck_width = neck};
  }

  std::string file_;
  Walls inlet_, outlet_, walls_;
};

// The rectangle that closes the channel at x, with its normal against (-1) or along (+1) the flow.
Walls opening(double x, double half_width, double height, bool inlet) {
  const Vec3 a(x, -half_width, 0), b(x, half_width, 0), c(x, half_width, height), d(x, -half_width, height);
  if (inlet) return {{{a, b, c}}, {{a, c, d}}};
  return {{{a, c, b}}, {{a, d, c}}};
}

}  // namespace

double stl_unit(const Scene& scene) {
  return scene.geometry.stl_unit > 0 ? scene.geometry.stl_unit : 1;
}

std::string stl_content_hash(const Scene& scene) {
  std::ifstream stream(scene.geometry.stl, std::ios::binary);
  require(stream.good(), "geometry.stl = \"{}\" (the file cannot be read)", scene.geometry.stl);
  return content_hash({std::istreambuf_iterator<char>(stream), {}});
}

bool is_stl_channel(const Scene& scene) {
  return !scene.geometry.stl.empty() && scene.geometry.inlet_position < 0;
}

StlChannel read_stl_channel(const Scene& scene) { return Reader(scene).channel(); }

std::string channel_stl(const Scene& scene, double unit) {
  require(scene.geometry.stl.empty(), "geometry.stl = {} (the channel is a file already)", scene.geometry.stl);
  const Walls walls = channel_walls(scene);
  const ChannelOutline sides = channel_outline(scene);
  const double height = scene.geometry.neck_height;
  return stl_text({{"walls", walls},
                   {"inlet", opening(sides.upper.front().x(), sides.upper.front().y(), height, true)},
                   {"outlet", opening(sides.upper.back().x(), sides.upper.back().y(), height, false)}},
                  unit);
}

}  // namespace clog
