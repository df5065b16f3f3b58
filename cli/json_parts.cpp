#include "cli/json_parts.hpp"

#include <cmath>
#include <sstream>

#include "coupling/scene/readable_scene.hpp"

namespace clogflow::cli {

using nlohmann::json;

json json_head(const std::string& name) {
  return {{"format", "clogflow " + name}, {"version", 1}, {"program", CLOG_VERSION}};
}

json number_or_null(double value) { return std::isfinite(value) ? json(value) : json(); }

json scene_json(const std::string& effective_scene) {
  json scene = json::object();
  std::istringstream lines(readable_scene(effective_scene));
  std::string section;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('[')) section = line.substr(1, line.find(']') - 1) + ".";
    const std::size_t equals = line.find(" = ");
    if (equals == std::string::npos || line.starts_with('#')) continue;
    // Values as the program prints them are JSON too.
    const std::string text = line.substr(equals + 3);
    const json value = json::parse(text, nullptr, false);
    scene[section + line.substr(0, equals)] = value.is_discarded() ? json(text) : value;
  }
  return scene;
}

}  // namespace clogflow::cli
