// Telling chosen keys from implied ones by asking the scene's own defaults.
#include "postprocess/events/sweep_axis.hpp"

#include <algorithm>
#include <charconv>
#include <numbers>
#include <set>

#include "coupling/base/require.hpp"
#include "coupling/base/units.hpp"

namespace clogflow::postprocess {
namespace {

/// Whether the scene without this line has the same value by default.
bool is_implied(const RunGroup& group, const std::string& key) {
  try {
    const Scene scene = parse_scene(without_key(group.scene_text, key), "a swept scene");
    const SceneLines lines = scene_lines(effective_scene(scene));
    const auto implied = lines.find(key), written = group.lines.find(key);
    if (written == group.lines.end()) return implied == lines.end();
    return implied != lines.end() && implied->second == written->second;
  } catch (const Error&) {
    return false;  // a scene cannot do without it
  }
}

std::optional<double> as_number(const std::string& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, status] = std::from_chars(text.data(), end, value);
  if (status != std::errc() || stop != end) return {};
  return value;
}

std::optional<Quantity> as_quantity(const std::string& text) {
  try {
    return parse_quantity(text);
  } catch (const Error&) {
    return {};
  }
}

/// Lengths below a millimetre in um, times below a second in ms, angles in degrees.
std::string in_words(const Quantity& quantity) {
  const auto [si, dimension, is_angle] = quantity;
  if (is_angle) return fmt::format("{:.4g} deg", si * 180 / std::numbers::pi);
  if (dimension == dimension::length && si < 1e-3) return fmt::format("{:.4g} um", si * 1e6);
  if (dimension == dimension::time && si < 1) return fmt::format("{:.4g} ms", si * 1e3);
  return fmt::format("{:.4g} {}", si, si_unit(dimension));
}

double neck_ratio(const RunGroup& group) { return group.scene.geometry.neck_width / group.scene.particles.diameter; }

/// Keys that decide D/d.
bool is_in_neck_ratio(const std::string& key) { return key == "particles.diameter" || key == "geometry.neck_width"; }

std::string short_name(const std::string& key) { return key.substr(key.find('.') + 1); }

}  // namespace

KeyValue key_value(const SceneLines& lines, const std::string& key) {
  const auto found = lines.find(key);
  if (found == lines.end()) return {"not given", {}, "1"};
  std::string text = found->second;
  const bool quoted = text.size() >= 2 && text.front() == '"' && text.back() == '"';
  if (!quoted) return {text, as_number(text), "1"};
  text = text.substr(1, text.size() - 2);
  const auto quantity = as_quantity(text);
  if (!quantity) return {text, {}, "1"};
  return {in_words(*quantity), quantity->si, quantity->is_angle ? "rad" : si_unit(quantity->dimension)};
}

std::vector<std::string> chosen_keys(const std::vector<RunGroup>& groups) {
  std::vector<std::string> keys;
  for (const std::string& key : swept_keys(groups)) {
    const auto implied = [&](const RunGroup& group) { return is_implied(group, key); };
    if (!std::ranges::all_of(groups, implied)) keys.push_back(key);
  }
  if (keys.size() > 1) std::erase(keys, "time.end");
  return keys;
}

SweepAxis sweep_axis(const std::vector<RunGroup>& groups, const std::vector<std::string>& chosen) {
  if (chosen.empty()) return {};
  const auto in_ratio = std::ranges::find_if(chosen, is_in_neck_ratio);
  const bool has_necks =
      std::ranges::all_of(groups, [](const RunGroup& group) { return group.scene.geometry.neck_width > 0; });
  if (in_ratio != chosen.end() && has_necks) return {*in_ratio, true, true, "1"};
  SweepAxis axis{chosen.front(), false, true, key_value(groups.front().lines, chosen.front()).unit};
  axis.numeric = std::ranges::all_of(
      groups, [&](const RunGroup& group) { return key_value(group.lines, axis.key).number.has_value(); });
  return axis;
}

std::vector<double> axis_values(const std::vector<RunGroup>& groups, const SweepAxis& axis) {
  std::vector<std::string> words;
  std::vector<double> values;
  for (const RunGroup& group : groups) {
    if (axis.neck_ratio) {
      values.push_back(neck_ratio(group));
      continue;
    }
    const KeyValue value = key_value(group.lines, axis.key);
    if (axis.numeric && value.number) {
      values.push_back(*value.number);
      continue;
    }
    const auto known = std::ranges::find(words, value.text);
    values.push_back(static_cast<double>(known - words.begin()));
    if (known == words.end()) words.push_back(value.text);
  }
  return values;
}

std::vector<std::string> series_labels(const std::vector<RunGroup>& groups, const SweepAxis& axis,
                                       const std::vector<std::string>& chosen) {
  std::vector<std::string> labels;
  for (const RunGroup& group : groups) {
    std::string label;
    for (const std::string& key : chosen) {
      if (key == axis.key || (axis.neck_ratio && is_in_neck_ratio(key))) continue;
      label += fmt::format("{}{} = {}", label.empty() ? "" : ", ", short_name(key), key_value(group.lines, key).text);
    }
    labels.push_back(label);
  }
  return labels;
}

std::string group_label(const RunGroup& group, const std::vector<std::string>& chosen) {
  const bool has_neck = group.scene.geometry.neck_width > 0;
  std::string label = has_neck ? fmt::format("D/d = {:.3g}", neck_ratio(group)) : "";
  for (const std::string& key : chosen) {
    if (has_neck && key == "particles.diameter") continue;
    label += fmt::format("{}{} = {}", label.empty() ? "" : ", ", short_name(key), key_value(group.lines, key).text);
  }
  return label.empty() ? "all runs" : label;
}

}  // namespace clogflow::postprocess
