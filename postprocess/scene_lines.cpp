// Splits the effective scene into keys.
#include "postprocess/scene_lines.hpp"

#include <sstream>
#include <string_view>

namespace clog::postprocess {
namespace {

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(" \t\r") - first + 1));
}

}  // namespace

SceneLines scene_lines(const std::string& effective_scene) {
  SceneLines lines;
  std::istringstream in(effective_scene);
  std::string section;
  for (std::string line; std::getline(in, line);) {
    line = trimmed(line);
    if (line.empty() || line.front() == '#') continue;
    if (line.front() == '[') {
      section = line.substr(1, line.find(']') - 1) + ".";
      continue;
    }
    if (section == "ensemble." || section == "output.") continue;
    const auto equals = line.find('=');
    if (equals == std::string::npos) continue;
    lines[section + trimmed(std::string_view(line).substr(0, equals))] =
        trimmed(std::string_view(line).substr(equals + 1));
  }
  return lines;
}

std::vector<std::string> differing_keys(const SceneLines& a, const SceneLines& b) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : a) {
    const auto other = b.find(key);
    if (other == b.end() || other->second != value) keys.push_back(key);
  }
  for (const auto& [key, value] : b) {
    if (!a.contains(key)) keys.push_back(key);
  }
  return keys;
}

}  // namespace clog::postprocess
