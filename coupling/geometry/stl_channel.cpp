#include "coupling/geometry/stl_channel.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <mutex>
#include <numbers>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "coupling/base/content_hash.hpp"
#include "coupling/base/require.hpp"
#include "coupling/base/shown_text.hpp"
#include "coupling/geometry/channel_geometry.hpp"
#include "coupling/geometry/stl_openings.hpp"
#include "coupling/geometry/stl_surface.hpp"
#include "coupling/geometry/wall_edges.hpp"
#include "coupling/geometry/wall_outlines.hpp"
#include "coupling/geometry/wall_sections.hpp"

namespace clogflow {
namespace {

std::string place_text(const Vec3& p) { return fmt::format("({:.4g}, {:.4g}, {:.4g}) m", p.x, p.y, p.z); }

// Each edge must belong to two triangles which run along it in opposite directions.
void require_closed(const StlSurface& surface, const std::string& file) {
  const auto& [rims, mesh] = std::tie(surface.rims, surface.mesh);
  require(rims.empty(),
          "{}: the surface is not closed (a hole of {:.3g} m around at {}; corners farther apart than "
          "geometry.stl_tolerance = {:.3g} m are not one{}); close it, inlet and outlet included",
          file, rims.empty() ? 0 : rims[0].length, rims.empty() ? "" : place_text(rims[0].place), surface.tolerance,
          surface.note.empty() ? "" : "; " + surface.note);
  WallEdges(mesh.corner, mesh.corners).for_each([&, &mesh = mesh](int low, std::span<const EdgeUse> uses) {
    const auto forwards = [&](const EdgeUse& use) { return mesh.corner[use.triangle()][use.k()] == low; };
    const bool pair = uses.size() == 2;
    if (pair && forwards(uses[0]) != forwards(uses[1])) return;
    const std::string at = place_text(mesh.triangles[uses[0].triangle()].corner[uses[0].k()]);
    require(pair, "{}: {} triangles meet in the edge at {} (must be 2)", file, uses.size(), at);
    throw Error(
        fmt::format("{}: the triangles on the two sides of the edge at {} are turned differently (corners in "
                    "opposite order); turn one of them",
                    file, at));
  });
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
  for (const Triangle& t : walls) sum += cross(t.corner[1] - t.corner[0], t.corner[2] - t.corner[0]).norm() / 2;
  return sum;
}

// Twice six times the signed volume is positive for normals that point out.
double volume(const Walls& surface) {
  double six = 0;
  for (const Triangle& t : surface) six += dot(t.corner[0], cross(t.corner[1], t.corner[2]));
  return six / 6;
}

class Reader {
public:
  explicit Reader(const Geometry& geometry)
      : file_("geometry.stl = " + geometry.stl),
        facets_(channel_facets(read_stl_solids(geometry.stl), stl_unit(geometry), file_)),
        surface_(stl_surface(std::move(facets_.all), geometry)) {}

  StlChannel channel() {
    require_closed(surface_, file_);
    Walls all = surface_.joined.walls();
    if (volume(all) > 0)
      for (Triangle& t : all) std::swap(t.corner[1], t.corner[2]);
    Box box;
    box.add(all);
    for (std::size_t k = 0; k < all.size(); ++k) {
      const ChannelPart part = facets_.part[surface_.joined.source[k]];
      (part == ChannelPart::inlet ? inlet_ : part == ChannelPart::outlet ? outlet_ : walls_).push_back(all[k]);
    }
    StlChannel channel = measured(box);
    if (!surface_.note.empty()) channel.note = file_ + ": " + surface_.note;
    return channel;
  }

private:
  void require_flat(const Walls& part, const char* name, double x, double tolerance) const {
    for (const Triangle& t : part)
      for (const Vec3& corner : t.corner)
        require(std::abs(corner.x - x) < tolerance,
                "{}: the {} has a corner at x = {:.6g} m (all must lie in the plane x = {:.6g} m, the "
                "{} of the surface: the flow runs along x)",
                file_, name, corner.x, x, name == std::string("inlet") ? "upstream end" : "downstream end");
  }

  // Corners at one distance from the middle of the inlet, and the area of a regular polygon of them.
  RoundInlet round_inlet(const Box& in) const {
    const Vec2 middle((in.low.y + in.high.y) / 2, (in.low.z + in.high.z) / 2);
    std::set<std::pair<double, double>> rim;
    double radius = 0;
    for (const Triangle& t : inlet_)
      for (const Vec3& corner : t.corner) radius = std::max(radius, (Vec2(corner.y, corner.z) - middle).norm());
    for (const Triangle& t : inlet_)
      for (const Vec3& corner : t.corner)
        if ((Vec2(corner.y, corner.z) - middle).norm() > (1 - 1e-3) * radius) rim.emplace(corner.y, corner.z);
    const double turn = 2 * std::numbers::pi / static_cast<double>(rim.size());
    constexpr std::size_t fewest_sides = 24;
    const double regular = std::pow(radius, 2) * std::sin(turn) * std::numbers::pi / turn;
    if (rim.size() < fewest_sides || std::abs(area(inlet_) / regular - 1) > 2e-3) return {};
    return {2 * radius * std::cos(turn / 2), area(inlet_)};
  }

  static double width(const WallOutline& outline) {
    const auto [low, high] = std::ranges::minmax(outline.corners, {}, [](const Vec2& corner) { return corner.x(); });
    return high.x() - low.x();
  }

  StlChannel measured(const Box& box) const {
    const double tolerance = std::max(same_length * (box.high.x - box.low.x), surface_.tolerance);
    require_flat(inlet_, "inlet", box.low.x, tolerance);
    require_flat(outlet_, "outlet", box.high.x, tolerance);
    Box in;
    in.add(inlet_);
    const Vec3 size = in.high - in.low;
    const RoundInlet round = round_inlet(in);
    require((round.diameter > 0 || std::abs(area(inlet_) / (size.y * size.z) - 1) < 1e-4) &&
                std::abs(in.low.y + in.high.y) < tolerance && std::abs(in.low.z) < tolerance,
            "{}: the inlet fills {:.4g} of y from {:.4g} to {:.4g} m, z from {:.4g} to {:.4g} m (must be a whole "
            "rectangle, or a circle of 24 or more equal sides, with y = 0 in its middle and z = 0 at its floor)",
            file_, area(inlet_) / (size.y * size.z), in.low.y, in.high.y, in.low.z, in.high.z);
    const double straight_end = straight_until(walls_);
    require(box.low.x < 0 && box.high.x > 0,
            "{}: reaches from x = {:.4g} to {:.4g} m (x = 0 must lie "
            "between, at the neck's entrance)",
            file_, box.low.x, box.high.x);
    require(straight_end > box.low.x + tolerance && straight_end < tolerance,
            "{}: its walls are parallel to x up to {:.4g} m (they must be between the inlet, x = {:.4g} m, and some "
            "place before the neck, x = 0: there particles enter and the flow is developed)",
            file_, straight_end, box.low.x);
    const double behind = 2 * tolerance;
    const std::vector<WallOutline> necks = openings_at(walls_, behind);
    const WallSection section = section_at(walls_, behind);
    double widest = necks.size() > 1 ? 0 : section.width();
    for (const WallOutline& neck : necks)
      if (necks.size() > 1) widest = std::max(widest, width(neck));
    return {.walls = walls_,
            .inlet = box.low.x,
            .outlet = box.high.x,
            .width = size.y,
            .height = size.z,
            .straight_end = std::min(straight_end, 0.0),
            .neck_width = widest,
            .neck_length = neck_length(walls_, behind, box.high.x),
            .round = round,
            .neck_area = necks.size() > 1 || round.diameter > 0 ? section.area : 0,
            .note = {}};
  }

  std::string file_;
  ChannelFacets facets_;
  StlSurface surface_;
  Walls inlet_, outlet_, walls_;
};

// The rectangle that closes the channel at x, with its normal against (-1) or along (+1) the flow.
Walls opening(double x, double half_width, double height, bool inlet) {
  const Vec3 a(x, -half_width, 0), b(x, half_width, 0), c(x, half_width, height), d(x, -half_width, height);
  if (inlet) return {{{a, b, c}}, {{a, c, d}}};
  return {{{a, c, b}}, {{a, d, c}}};
}

}  // namespace

std::string stl_content_hash(const Geometry& geometry) {
  // A scene inside a flow file may name anything; to open a pipe waits for its other end.
  std::error_code ignored;
  require(std::filesystem::is_regular_file(geometry.stl, ignored), "geometry.stl = \"{}\" (there is no such file)",
          shown_text(geometry.stl));
  std::ifstream stream(geometry.stl, std::ios::binary);
  require(stream.good(), "geometry.stl = \"{}\" (the file cannot be read)", geometry.stl);
  return content_hash({std::istreambuf_iterator<char>(stream), {}});
}

bool is_stl_channel(const Geometry& geometry) { return !geometry.stl.empty() && geometry.inlet_position < 0; }

std::shared_ptr<const StlChannel> read_stl_channel(const Geometry& g) {
  const auto read = [&] { return std::make_shared<const StlChannel>(Reader(g).channel()); };
  // A file whose content the scene does not name may change from one call to the next.
  if (g.stl_content.empty()) return read();
  static std::mutex one_at_a_time;
  static std::pair<std::string, std::shared_ptr<const StlChannel>> last;
  const std::string key = fmt::format("{} {} {} {}", g.stl_content, g.stl_unit, g.stl_tolerance, g.stl);
  const std::lock_guard lock(one_at_a_time);
  if (last.first != key) last = {key, read()};
  return last.second;
}

std::string channel_stl(const Geometry& geometry, double unit) {
  require(geometry.stl.empty(), "geometry.stl = {} (the channel is a file already)", geometry.stl);
  const Walls walls = channel_walls(geometry);
  const ChannelOutline sides = channel_outline(geometry);
  const double height = geometry.neck_height;
  return stl_text({{"walls", walls},
                   {"inlet", opening(sides.upper.front().x(), sides.upper.front().y(), height, true)},
                   {"outlet", opening(sides.upper.back().x(), sides.upper.back().y(), height, false)}},
                  unit);
}

}  // namespace clogflow
