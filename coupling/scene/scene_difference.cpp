#include "coupling/scene/scene_difference.hpp"

#include <algorithm>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "coupling/base/require.hpp"
#include "coupling/base/units.hpp"
#include "coupling/scene/readable_scene.hpp"

namespace clogflow {
namespace {

/// The one list of what cannot change a trajectory. Proved by tests/faults/test_lengthened.cpp.
constexpr std::pair<std::string_view, KeyRole> harmless[] = {
    {"time.end", KeyRole::length},
    {"output.snapshot_interval", KeyRole::records},
    {"output.series_interval", KeyRole::records},
    {"output.checkpoint_interval", KeyRole::nothing},
    {"ensemble.seeds", KeyRole::nothing},
    {"ensemble.sweep", KeyRole::nothing},
};

constexpr std::pair<std::string_view, std::string_view> later[] = {
    {"contact.law", "\"hertz\""},
    {"contact.turning", "\"luding\""},
    {"drag.law", "\"hoef\""},
    {"porosity.method", "\"strips\""},
    {"porosity.neck", "false"},
    {"unclog.region", "0"},
    {"unclog.shortcut", "false"},
    {"inlet.concentration", "0"},
    {"output.contacts", "false"},
    {"flow.drive", "\"rate\""},
    {"flow.oscillation.shape", "\"sine\""},
    {"particles.size_distribution", "\"normal\""},
    {"particles.size_spread", "0"},
    {"gravity", "[\"0 m/s2\", \"0 m/s2\", \"0 m/s2\"]"},
};

bool is_as_before(const std::string& key, const std::string& value) {
  return std::ranges::find(later, std::pair<std::string_view, std::string_view>(key, value)) != std::end(later);
}

using Values = std::vector<std::pair<std::string, std::string>>;

/// Of the lines "[section]" and "key = value" that effective_scene() prints.
Values values_of(const std::string& effective_scene) {
  std::istringstream in(effective_scene);
  std::string section;
  Values values;
  for (std::string line; std::getline(in, line);) {
    const auto equals = line.find(" = ");
    if (line.starts_with('[') && line.ends_with(']'))
      section = line.substr(1, line.size() - 2) + ".";
    else if (equals != std::string::npos)
      values.emplace_back(section + line.substr(0, equals), line.substr(equals + 3));
  }
  return values;
}

std::string value_of(const Values& values, const std::string& key) {
  const auto found = std::ranges::find(values, key, &Values::value_type::first);
  return found == values.end() ? "nothing" : found->second;
}

std::optional<Quantity> quantity_in(const std::string& value) {
  if (value.size() < 2 || !value.starts_with('"') || !value.ends_with('"')) return {};
  try {
    return parse_quantity(std::string_view(value).substr(1, value.size() - 2));
  } catch (const Error&) {
    return {};
  }
}

bool same_value(const std::string& a, const std::string& b) {
  if (a == b) return true;
  const auto x = quantity_in(a), y = quantity_in(b);
  return x && y && x->si == y->si && x->dimension == y->dimension;
}

}  // namespace

std::span<const std::pair<std::string_view, std::string_view>> later_keys() { return later; }

KeyRole role_of(std::string_view key) {
  const auto* found = std::ranges::find(harmless, key, &std::pair<std::string_view, KeyRole>::first);
  return found == std::end(harmless) ? KeyRole::trajectory : found->second;
}

std::string SceneDifference::words() const {
  return fmt::format("{} = {}, now {}", key, readable_value(key, before), readable_value(key, now));
}

std::vector<SceneDifference> scene_differences(const std::string& before, const std::string& now) {
  if (before == now) return {};
  const Values a = values_of(before), b = values_of(now);
  std::vector<SceneDifference> differences;
  for (const auto& [key, value] : a)
    if (const std::string other = value_of(b, key); !same_value(value, other))
      differences.push_back({key, value, other});
  for (const auto& [key, value] : b)
    if (value_of(a, key) == "nothing" && !is_as_before(key, value)) differences.push_back({key, "nothing", value});
  return differences;
}

std::optional<SceneDifference> find_role(const std::vector<SceneDifference>& differences, KeyRole role) {
  for (const SceneDifference& each : differences)
    if (role_of(each.key) == role) return each;
  return {};
}

}  // namespace clogflow
