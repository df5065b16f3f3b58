// A row of the key table taken apart: its kind tells unit and bounds, its line of explanation meaning and default.
#include "coupling/keys/key_reference.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "coupling/base/nearest_word.hpp"
#include "coupling/base/require.hpp"
#include "coupling/base/shown_text.hpp"

namespace clogflow {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 17> sections{{
    {"", "before the first section"},
    {"geometry", "the channel, or an STL file of it; flow is along x, the neck begins at x = 0"},
    {"box", "plain walls of a laboratory scene"},
    {"fluid", "the liquid"},
    {"flow", "the undisturbed flow: where it comes from, how fast, how it changes in time"},
    {"particles", "the spheres: sizes, density, start"},
    {"contact", "forces of touching spheres and walls"},
    {"lubrication", "films between spheres that come close"},
    {"drag", "what the flow does to a sphere"},
    {"porosity", "how densely the spheres lie, which the drag depends on"},
    {"inlet", "how spheres come in, and what is there at time 0"},
    {"unclog", "what happens at a clog"},
    {"time", "length of the run, its step, and numerics"},
    {"passages", "what counts as passed"},
    {"output", "what is written, and how often"},
    {"fidelity", "cheaper or better numerics by name or wanted accuracy"},
    {"ensemble", "many runs: seeds and sweeps"},
}};

// "a length" without its article.
std::string kind_of(Dimension dimension) {
  const std::string words = quantity_words(dimension).name;
  return dimension == dimension::number ? "number" : words.substr(words.find(' ') + 1);
}

std::string bounds_of(const Range& range) {
  constexpr std::string_view opening = "must be ";
  const std::string words = range.words();
  return words.starts_with("must be a") ? "" : words.substr(opening.size());
}

// What each kind of value adds. A default that the table does not name is what a fresh Scene holds.
struct Describer {
  KeyEntry& entry;

  void operator()(const NumberSlot& slot) const {
    const bool pure = slot.dimension == dimension::number;
    entry.kind = kind_of(slot.dimension);
    entry.unit = pure ? "" : si_unit(slot.dimension);
    entry.bounds = bounds_of(slot.range);
    const std::string example = quantity_words(slot.dimension).example;
    entry.example = pure ? "0.1" : '"' + example + '"';
    if (pure && !slot.range.contains(0.1)) entry.example = fmt::format("{}", std::max(slot.range.low, 1.0));
    if (slot.range.high <= 0) entry.example = "\"-" + example + '"';
  }
  void operator()(const AngleSlot&) const {
    entry.kind = "angle";
    entry.unit = "rad";
    entry.bounds = "in (0 deg, 90 deg]";
    entry.example = "\"60 deg\"";
  }
  void operator()(const VectorSlot& slot) const {
    entry.kind = kind_of(slot.dimension) + ", three components";
    entry.unit = si_unit(slot.dimension);
    const std::string one = quantity_words(slot.dimension).example;
    entry.example = fmt::format("[\"{}\", \"0 {}\", \"0 {}\"]", one, entry.unit, entry.unit);
  }
  void operator()(const CountSlot& slot) const {
    entry.kind = "whole number";
    entry.bounds = bounds_of(slot.range);
    entry.example = "3";
  }
  void operator()(const SwitchSlot& slot) const {
    Scene fresh;
    entry.kind = "true or false";
    entry.example = "true";
    if (entry.fallback.empty()) entry.fallback = slot.at(fresh) ? "true" : "false";
  }
  void operator()(const TextSlot&) const {
    entry.kind = "text";
    entry.example = "\"name\"";
  }
  void operator()(const WordSlot& slot) const {
    entry.kind = "word";
    entry.words.assign(slot.words.begin(), slot.words.end());
    entry.example = '"' + entry.words.back() + '"';
    if (entry.fallback.empty()) entry.fallback = entry.words.at(static_cast<std::size_t>(slot.get(Scene{})));
  }
  void operator()(const TextsSlot&) const {
    entry.kind = "list of texts";
    entry.example = "[\"particles.diameter = 25 um, 33 um\"]";
  }
  void operator()(const SeedsSlot&) const {
    entry.kind = "whole numbers";
    entry.example = "\"1-40\"";
  }
  void operator()(const SpeciesSlot&) const {
    entry.kind = "list of tables";
    entry.example = "[{diameter = \"25 um\", share = 0.5}, {diameter = \"33 um\", share = 0.5}]";
  }
};

// "meaning; default ..." into its two parts.
void split(std::string_view doc, KeyEntry& entry) {
  const std::size_t fallback = doc.find("; default"), required = doc.find("; required");
  entry.meaning = doc.substr(0, std::min(fallback, required));
  if (required != std::string_view::npos) entry.fallback = doc.substr(required + 2);
  if (fallback == std::string_view::npos) return;
  entry.fallback = doc.substr(fallback + std::string_view("; default").size());
  entry.fallback.erase(0, entry.fallback.find_first_not_of(": "));
}

// Of a key that is not known, or a section: what the person may have meant.
std::string suggestion(std::string_view name) {
  std::string_view nearest = nearest_key(name);
  std::size_t least = nearest.empty() ? name.size() : edit_distance(name, nearest);
  for (const Key& key : scene_keys())
    for (std::size_t dot = key.path.find('.'); dot != std::string_view::npos; dot = key.path.find('.', dot + 1)) {
      const std::string_view section = key.path.substr(0, dot);
      const std::size_t distance = edit_distance(name, section);
      if (distance < least && is_near(distance, name)) least = distance, nearest = section;
    }
  return nearest.empty() ? "clog keys lists all" : fmt::format("is \"{}\" meant?", nearest);
}

}  // namespace

std::string KeyEntry::allowed() const {
  if (words.empty()) return bounds;
  std::string all;
  for (std::size_t i = 0; i < words.size(); ++i)
    all += fmt::format("{}\"{}\"", i == 0 ? "" : i + 1 == words.size() ? " or " : ", ", words[i]);
  return all;
}

KeyEntry describe(const Key& key) {
  KeyEntry entry;
  entry.name = key.path;
  entry.section = section_of(key.path);
  split(key.doc, entry);
  std::visit(Describer{entry}, key.slot);
  if (entry.fallback.empty()) entry.fallback = "none";
  return entry;
}

std::string_view section_meaning(std::string_view section) {
  const auto* found = std::ranges::find(sections, section, &std::pair<std::string_view, std::string_view>::first);
  return found == sections.end() ? std::string_view{} : found->second;
}

std::vector<KeyEntry> entries_of(std::string_view name) {
  std::vector<KeyEntry> entries;
  const std::string inside = fmt::format("{}.", name);
  for (const Key& key : scene_keys())
    if (name.empty() || key.path == name || key.path.starts_with(inside)) entries.push_back(describe(key));
  require(!entries.empty(), "no scene key or section is named \"{}\" ({})", shown_text(name), suggestion(name));
  return entries;
}

}  // namespace clogflow
