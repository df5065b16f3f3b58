// The one table of scene keys: reading, checking, printing and suggestions all walk it.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "coupling/base/units.hpp"
#include "coupling/scene/scene.hpp"

namespace clogflow {

/// Allowed values in SI units.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_allowed = true;
  bool high_allowed = true;

  bool contains(double value) const {
    return (low_allowed ? value >= low : value > low) && (high_allowed ? value <= high : value < high);
  }
  /// "must be in (0, 1]", "must be > 0"
  std::string words() const;
};

struct NumberSlot {
  double& (*at)(Scene&);
  Dimension dimension;
  Range range;
};
struct AngleSlot {
  double& (*at)(Scene&);  ///< [rad]
};
struct VectorSlot {
  std::array<double, 3>& (*at)(Scene&);
  Dimension dimension;
};
struct CountSlot {
  int& (*at)(Scene&);
  Range range;
};
struct SwitchSlot {
  bool& (*at)(Scene&);
};
struct TextSlot {
  std::string& (*at)(Scene&);
};
/// One of several words, told by its place in the list.
struct WordSlot {
  std::vector<std::string_view> words;
  int (*get)(const Scene&);
  void (*set)(Scene&, int);
};
struct TextsSlot {
  std::vector<std::string>& (*at)(Scene&);
};
struct SeedsSlot {
  std::vector<std::uint64_t>& (*at)(Scene&);
};

struct SpeciesSlot {
  std::vector<Species>& (*at)(Scene&);
};

using Slot = std::variant<NumberSlot, AngleSlot, VectorSlot, CountSlot, SwitchSlot, TextSlot, WordSlot, TextsSlot,
                          SeedsSlot, SpeciesSlot>;

struct Key {
  std::string_view path;  ///< "contact.friction.sliding"
  Slot slot;
  /// One line for a human: "meaning", "meaning; default ..." or "meaning; required ...". Without the last two, a word
  /// or a switch defaults to what a Scene holds, and all else to nothing. coupling/keys prints it.
  std::string_view doc;
};

/// In the order in which a scene is printed.
const std::vector<Key>& scene_keys();

/// nullptr if there is none.
const Key* find_key(std::string_view path);

/// "contact" for "contact.friction.sliding"; empty for a key before the first section.
std::string_view section_of(std::string_view path);

bool is_section(std::string_view path);

/// The known key with the smallest edit distance; empty if none is near.
std::string_view nearest_key(std::string_view path);

/// "unknown key", and the nearest one if there is any.
std::string unknown_key(std::string_view path);

/// Largest half angle of the narrowing: a sudden step [rad].
inline constexpr double largest_half_angle = std::numbers::pi / 2;

}  // namespace clogflow
