#include "trade/unlike.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "coupling/scene/scene_difference.hpp"

namespace clogflow::trade {
namespace {

constexpr std::size_t shown = 3;

/// Beginnings of keys. A key that is not named here counts.
constexpr std::string_view compared[] = {"particles.diameter",
                                         "particles.roughness",
                                         "lubrication.cutoff",
                                         "unclog.after",
                                         "unclog.strain",
                                         "unclog.duration",
                                         "porosity.update_interval",
                                         "inlet.rate",
                                         "contact.youngs_modulus",
                                         "contact.wall_youngs_modulus",
                                         "time.",
                                         "fidelity.",
                                         "passages.plane"};
constexpr std::string_view scale[] = {"geometry.",          "fluid.",     "particles.density", "flow.source",
                                      "flow.mean_velocity", "flow.mesh_", "flow.grid_spacing", "flow.extrapolate",
                                      "flow.rescale"};

/// Their bursts are the same within some per cent. \measured docs/reports/friction.md
bool gives_free_bursts(std::string_view protocol) {
  return protocol == "\"stop\"" || protocol == "\"restart\"" || protocol == "\"rewind\"";
}

bool counts(const SceneDifference& difference) {
  const std::string_view key = difference.key;
  const auto begins = [&](std::string_view beginning) { return key.starts_with(beginning); };
  if (key == "geometry.half_angle") return true;
  if (key == "unclog.protocol" && gives_free_bursts(difference.before) && gives_free_bursts(difference.now))
    return false;
  return role_of(key) == KeyRole::trajectory && std::ranges::none_of(compared, begins) &&
         std::ranges::none_of(scale, begins);
}

/// Walls take the friction of the particles unless they are given their own.
bool only_follows(const SceneDifference& wall, const std::vector<SceneDifference>& all) {
  constexpr std::string_view of_walls = "contact.wall_";
  if (!wall.key.starts_with(of_walls)) return false;
  const std::string own = "contact." + wall.key.substr(of_walls.size());
  return std::ranges::any_of(
      all, [&](const SceneDifference& d) { return d.key == own && d.before == wall.before && d.now == wall.now; });
}

}  // namespace

std::string unlike(const std::string& studied, const Scene& scene, std::string_view but) {
  const std::vector<SceneDifference> all = scene_differences(studied, effective_scene(scene));
  std::vector<std::string> words;
  for (const SceneDifference& difference : all)
    if (counts(difference) && (but.empty() || !difference.key.starts_with(but)) && !only_follows(difference, all))
      words.push_back(difference.words());
  const std::size_t more = words.size() - std::min(words.size(), shown);
  words.resize(words.size() - more);
  return fmt::format("{}{}", fmt::join(words, ", "), more ? fmt::format(" and {} more", more) : "");
}

}  // namespace clogflow::trade
