// Splits the effective scene into keys.
#include "postprocess/events/scene_lines.hpp"

#include <sstream>
#include <string_view>

#include "coupling/scene/scene_difference.hpp"

namespace clogflow::postprocess {
namespace {

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(" \t\r") - first + 1));
}

/// Calls visit(line, key, value) for each line; key and value are empty where it has none.
template <class Visit>
void for_each_line(const std::string& effective_scene, const Visit& visit) {
  std::istringstream in(effective_scene);
  std::string section;
  for (std::string raw; std::getline(in, raw);) {
    const std::string line = trimmed(raw);
    const auto equals = line.find('=');
    if (!line.empty() && line.front() == '[') section = line.substr(1, line.find(']') - 1) + ".";
    if (line.empty() || line.front() == '#' || line.front() == '[' || equals == std::string::npos) {
      visit(raw, "", "");
      continue;
    }
    visit(raw, section + trimmed(std::string_view(line).substr(0, equals)),
          trimmed(std::string_view(line).substr(equals + 1)));
  }
}

}  // namespace

SceneLines scene_lines(const std::string& effective_scene) {
  SceneLines lines;
  for_each_line(effective_scene, [&](const std::string&, const std::string& key, const std::string& value) {
    if (!key.empty() && !key.starts_with("ensemble.") && !key.starts_with("output.")) lines[key] = value;
  });
  for (const auto& [key, value] : later_keys()) lines.try_emplace(std::string(key), value);
  return lines;
}

std::string without_key(const std::string& effective_scene, const std::string& key) {
  std::string text;
  for_each_line(effective_scene, [&](const std::string& line, const std::string& here, const std::string&) {
    if (here != key) text += line + "\n";
  });
  return text;
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

}  // namespace clogflow::postprocess
