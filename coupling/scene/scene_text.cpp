// The scene back to text: complete, in SI units, in the order of the key table.
#include <cmath>

#include "coupling/base/require.hpp"
#include "coupling/geometry/channel_shape.hpp"
#include "coupling/geometry/stl_channel.hpp"
#include "coupling/scene/scene_keys.hpp"

namespace clogflow {
namespace {

std::string in_quotes(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (static_cast<unsigned char>(c) < ' ' || c == 127) {
      result += fmt::format("\\u{:04x}", static_cast<unsigned char>(c));
    } else {
      result += c;
    }
  }
  return result + '"';
}

std::string number_text(double value, Dimension dimension) {
  if (dimension == dimension::number) return fmt::format("{}", value);
  return in_quotes(si_quantity(value, dimension));
}

std::string friction_text(const Friction& friction) {
  return fmt::format("{{sliding = {}, rolling = {}, torsion = {}}}", friction.sliding, friction.rolling,
                     friction.torsion);
}

// The value as TOML, or nothing where the value is one that means "not used": such a value lies
// outside its own allowed range, so the text without it is read back to the same scene.
struct Printer {
  Scene& scene;
  bool keep_zero_vector;

  std::string operator()(const NumberSlot& slot) const {
    const double value = slot.at(scene);
    return slot.range.contains(value) ? number_text(value, slot.dimension) : "";
  }
  std::string operator()(const AngleSlot& slot) const {
    const double value = slot.at(scene);
    return value > 0 ? in_quotes(fmt::format("{} rad", value)) : "";
  }
  std::string operator()(const VectorSlot& slot) const {
    const std::array<double, 3> v = slot.at(scene);
    if (v == std::array<double, 3>{} && !keep_zero_vector) return "";
    return fmt::format("[{}, {}, {}]", number_text(v[0], slot.dimension), number_text(v[1], slot.dimension),
                       number_text(v[2], slot.dimension));
  }
  std::string operator()(const CountSlot& slot) const { return std::to_string(slot.at(scene)); }
  std::string operator()(const SwitchSlot& slot) const { return slot.at(scene) ? "true" : "false"; }
  std::string operator()(const TextSlot& slot) const { return slot.at(scene).empty() ? "" : in_quotes(slot.at(scene)); }
  std::string operator()(const WordSlot& slot) const {
    return in_quotes(std::string(slot.words.at(static_cast<std::size_t>(slot.get(scene)))));
  }
  std::string operator()(const TextsSlot& slot) const {
    std::string all;
    for (const std::string& text : slot.at(scene)) all += (all.empty() ? "" : ", ") + in_quotes(text);
    return all.empty() ? "" : "[" + all + "]";
  }
  std::string operator()(const SpeciesSlot& slot) const {
    std::string all;
    for (const Species& each : slot.at(scene)) {
      all += fmt::format("{}{{diameter = {}, share = {}", all.empty() ? "" : ", ",
                         number_text(each.diameter, dimension::length), each.share);
      if (each.density > 0) all += ", density = " + number_text(each.density, dimension::density);
      if (each.has_friction())
        all += fmt::format(", friction = {}, wall_friction = {}", friction_text(each.friction),
                           friction_text(each.wall_friction));
      all += '}';
    }
    return all.empty() ? "" : "[" + all + "]";
  }
  std::string operator()(const SeedsSlot& slot) const { return in_quotes(format_seeds(slot.at(scene))); }
};

bool is_absent(const Scene& scene, std::string_view section) {
  return (section == "geometry" && !scene.geometry.present) || (section == "box" && !scene.box.present);
}

bool decides_flow(std::string_view path) {
  return path.starts_with("geometry.") || path.starts_with("fluid.") || path == "flow.mean_velocity" ||
         path == "flow.mesh_cells_per_neck" || path == "flow.extrapolate" || path == "flow.grid_spacing";
}

}  // namespace

std::string effective_scene(const Scene& scene) {
  Scene copy = scene;  // the table's accessors are for writing too
  std::string text;
  std::string_view section;
  for (const Key& key : scene_keys()) {
    const std::string_view here = section_of(key.path);
    if (is_absent(scene, here)) continue;
    const std::string value = std::visit(Printer{copy, here == "box"}, key.slot);
    if (value.empty()) continue;
    if (here != section) text += fmt::format("{}[{}]\n", text.empty() ? "" : "\n", here);
    section = here;
    text += fmt::format("{} = {}\n", here.empty() ? key.path : key.path.substr(here.size() + 1), value);
  }
  return text;
}

std::string flow_inputs(const Scene& scene) {
  Scene copy = scene;
  // Every longer channel has the same flow.
  if (scene.geometry.present && scene.geometry.stl.empty())
    copy.geometry.channel_length = solved_length(scene.geometry);
  std::string text;
  for (const Key& key : scene_keys()) {
    if (!decides_flow(key.path) || is_absent(scene, section_of(key.path))) continue;
    std::string value = std::visit(Printer{copy, false}, key.slot);
    if (value.empty()) continue;
    if (key.path == "geometry.stl_content") continue;
    if (key.path == "geometry.stl")
      value = scene.geometry.stl_content.empty() ? stl_content_hash(scene.geometry) : scene.geometry.stl_content;
    text += fmt::format("{} = {}\n", key.path, value);
  }
  return text;
}

}  // namespace clogflow
