// Drawn by the figures, the film and the player of the page.
#include "postprocess/output/shape_json.hpp"

#include <cmath>

#include "coupling/geometry/channel_geometry.hpp"
#include "coupling/geometry/stl_channel.hpp"
#include "coupling/geometry/wall_outlines.hpp"

namespace clogflow::postprocess {
namespace {

using nlohmann::json;

json corners_of(const Walls& walls) {
  constexpr double per_metre = 1e10;  // digits beyond are nothing to see, and long
  json numbers = json::array();
  for (const Triangle& triangle : walls)
    for (const Vec3& corner : triangle.corner)
      for (const double c : {corner.x, corner.y, corner.z}) numbers.push_back(std::round(c * per_metre) / per_metre);
  return numbers;
}

}  // namespace

json shape_json(const Scene& scene) {
  json shape{{"neck_width", scene.geometry.neck_width},
             {"neck_height", scene.geometry.neck_height},
             {"channel_width", scene.geometry.channel_width},
             {"channel_length", scene.geometry.channel_length},
             {"neck_length", scene.geometry.neck_length},
             {"half_angle", scene.geometry.half_angle},
             {"present", scene.geometry.present && (scene.geometry.stl.empty() || is_stl_channel(scene.geometry))},
             {"passage_plane", scene.passages.plane},
             {"mean_velocity", scene.flow.mean_velocity},
             {"diameter", scene.particles.diameter}};
  if (is_stl_channel(scene.geometry)) {
    // Half way up, or just beside it: at the middle itself lie corners.
    const double height = 0.4999 * scene.geometry.neck_height;
    const Walls& walls = read_stl_channel(scene.geometry)->walls;
    if (walls.size() <= most_drawn_triangles) shape["walls"] = corners_of(walls);
    for (const WallOutline& line : closed_outlines(cut_along(walls, height))) {
      json corners = json::array();
      for (const Vec2& corner : line.corners) corners.push_back({corner.x(), corner.y()});
      shape["fluid"].push_back(corners);
    }
  } else if (shape["present"]) {
    const ChannelOutline outline = channel_outline(scene.geometry);
    for (const auto& [name, points] : {std::pair("upper", outline.upper), {"lower", outline.lower}})
      for (const Vec2& point : points) shape[name].push_back({point.x(), point.y()});
  }
  if (scene.geometry.neck_width > 0) {
    shape["neck_ratio"] = scene.geometry.neck_width / scene.particles.diameter;
  }
  return shape;
}

}  // namespace clogflow::postprocess
