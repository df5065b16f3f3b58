#include "coupling/scene/sweep.hpp"

#include <algorithm>
#include <set>

#include "coupling/base/require.hpp"
#include "coupling/base/shown_text.hpp"
#include "coupling/scene/scene_keys.hpp"

namespace clogflow {

namespace {

constexpr std::size_t most_points = 100'000;

struct Sweep {
  std::string key;
  std::vector<std::string> values;
};

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(" \t") - first + 1));
}

Sweep read_sweep(const std::string& whole) {
  const std::string text = shown_text(whole);
  const std::size_t equals = whole.find('=');
  require(equals != std::string::npos,
          "--sweep {} (write key=value,value, e.g. --sweep \"particles.diameter=25 um,33 um\")", text);
  Sweep sweep{trimmed(std::string_view(whole).substr(0, equals)), {}};
  require(find_key(sweep.key) != nullptr, "--sweep {} ({})", text, unknown_key(sweep.key));
  require(section_of(sweep.key) != "ensemble", "--sweep {} (is no property of a run: use --seeds)", text);
  for (std::size_t at = equals + 1; at <= whole.size();) {
    const std::size_t end = std::min(whole.find(',', at), whole.size());
    const std::string value = trimmed(std::string_view(whole).substr(at, end - at));
    require(!value.empty() && value.find_first_of("[]{}\"'") == std::string::npos,
            "--sweep {} (\"{}\" is no single value: write key=value,value without brackets and quotes)", text,
            shown_text(value));
    require(std::ranges::find(sweep.values, value) == sweep.values.end(), "--sweep {} ({} is given twice)", text,
            shown_text(value));
    sweep.values.push_back(value);
    require(sweep.values.size() <= most_points, "--sweep {} (more than {} points)", text, most_points);
    at = end + 1;
  }
  return sweep;
}

/// "particles.diameter=33um". A slash would be a folder of its own, so it becomes "per".
std::string folder_part(const std::string& key, const std::string& value) {
  std::string name = key + "=";
  for (const char c : value)
    if (c == '/')
      name += "per";
    else if (c != ' ')
      name += c;
  return name;
}

}  // namespace

std::vector<SweepPoint> sweep_points(const std::vector<std::string>& sweeps) {
  std::vector<SweepPoint> points{{}};
  std::set<std::string> keys, folders;
  for (const std::string& text : sweeps) {
    const Sweep sweep = read_sweep(text);
    require(keys.insert(sweep.key).second, "--sweep {} (the key is swept twice)", shown_text(text));
    require(points.size() * sweep.values.size() <= most_points, "--sweep {} (more than {} points)", shown_text(text),
            most_points);
    std::vector<SweepPoint> more;
    for (const SweepPoint& point : points)
      for (const std::string& value : sweep.values) {
        SweepPoint& next = more.emplace_back(point);
        if (!point.folder.empty()) next.folder += ",";
        next.folder += folder_part(sweep.key, value);
        next.overrides.push_back(sweep.key + "=" + value);
      }
    points = std::move(more);
  }
  for (const SweepPoint& point : points)
    require(folders.insert(point.folder).second, "--sweep: two points have one folder, {}", shown_text(point.folder));
  return points;
}

}  // namespace clogflow
