// What a scene takes from the STL file of its channel: measured where the file of the scene is silent,
// compared where it is not.
#include <cmath>
#include <utility>

#include "coupling/base/require.hpp"
#include "coupling/geometry/stl_channel.hpp"
#include "coupling/geometry/stl_surface.hpp"
#include "coupling/scene/scene_draft.hpp"
#include "coupling/scene/scene_keys.hpp"

namespace clogflow {
namespace {

// A scene may round the lengths of its file.
constexpr double rounding = 0.01;

void measure(SceneDraft& draft, const char* path, double value) {
  const auto& slot = std::get<NumberSlot>(find_key(path)->slot);
  double& wanted = slot.at(draft.scene);
  require(!draft.has(path) || std::abs(value - wanted) <= rounding * std::abs(value),
          "{} (in {} it is {}, counted in units of {} m: is geometry.stl_unit right?)", draft.says(path),
          draft.scene.geometry.stl, format_quantity(value, slot.dimension), stl_unit(draft.scene.geometry));
  if (draft.has(path)) return;
  wanted = value;
  draft.given.emplace(path, Given{draft.scene.geometry.stl, format_quantity(value, slot.dimension)});
}

void refuse_shape(const SceneDraft& draft) {
  for (const char* path : {"half_angle", "half_angle_below", "neck_rounding", "step_width", "step_length",
                           "expansion_width", "expansion_length", "expansion_angle"}) {
    const std::string key = std::string("geometry.") + path;
    require(!draft.has(key), "{} (the shape comes from geometry.stl = {}: leave it out)", draft.says(key),
            draft.scene.geometry.stl);
  }
}

}  // namespace

void measure_stl(SceneDraft& draft) {
  auto& geometry = draft.scene.geometry;
  if (geometry.stl.empty() || !draft.has("geometry.neck_width")) return;
  refuse_shape(draft);
  const std::string content = stl_content_hash(draft.scene.geometry);
  require(geometry.stl_content.empty() || geometry.stl_content == content,
          "geometry.stl = {} (its content {} is not the {} of the scene: the file has changed)", geometry.stl, content,
          geometry.stl_content);
  geometry.stl_content = content;
  const auto read = read_stl_channel(draft.scene.geometry);
  const StlChannel& channel = *read;
  measure(draft, "geometry.neck_width", channel.neck_width);
  measure(draft, "geometry.neck_height", channel.height);
  measure(draft, "geometry.channel_width", channel.width);
  measure(draft, "geometry.channel_length", channel.straight_end - channel.inlet);
  measure(draft, "geometry.inlet_position", channel.inlet);
  measure(draft, "geometry.outlet_position", channel.outlet);
  measure(draft, "geometry.neck_length", channel.neck_length);
  for (const auto& [key, value] : {std::pair("geometry.inlet_diameter", channel.round.diameter),
                                   {"geometry.inlet_area", channel.round.area},
                                   {"geometry.neck_area", channel.neck_area}})
    if (value > 0 || draft.has(key)) measure(draft, key, value);
}

}  // namespace clogflow
