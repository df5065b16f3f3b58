// Goes through the lines and prints the quantities of each anew.
#include "coupling/scene/readable_scene.hpp"

#include <variant>

#include "coupling/base/require.hpp"
#include "coupling/base/units.hpp"
#include "coupling/scene/scene_keys.hpp"

namespace clogflow {
namespace {

bool holds_quantities(const std::string& path) {
  const Key* key = find_key(path);
  return key && (std::holds_alternative<NumberSlot>(key->slot) || std::holds_alternative<AngleSlot>(key->slot) ||
                 std::holds_alternative<VectorSlot>(key->slot) || std::holds_alternative<SpeciesSlot>(key->slot));
}

std::string readable(const std::string& text) {
  try {
    const Quantity quantity = parse_quantity(text);
    return quantity.is_angle ? format_angle(quantity.si) : format_quantity(quantity.si, quantity.dimension);
  } catch (const Error&) {
    return text;  // a file from elsewhere: shown as it is
  }
}

std::string with_readable_quotes(const std::string& value) {
  std::string result;
  std::size_t at = 0;
  for (std::size_t open; (open = value.find('"', at)) != std::string::npos;) {
    const std::size_t close = value.find('"', open + 1);
    if (close == std::string::npos) break;
    result += fmt::format("{}\"{}\"", value.substr(at, open - at), readable(value.substr(open + 1, close - open - 1)));
    at = close + 1;
  }
  return result + value.substr(at);
}

}  // namespace

std::string readable_value(const std::string& key, const std::string& value) {
  return holds_quantities(key) ? with_readable_quotes(value) : value;
}

std::string readable_scene(const std::string& effective_scene) {
  std::string result, section;
  for (std::size_t at = 0; at < effective_scene.size();) {
    const std::size_t end = std::min(effective_scene.find('\n', at), effective_scene.size());
    const std::string line = effective_scene.substr(at, end - at);
    const std::size_t equals = line.find(" = ");
    if (line.starts_with('[')) section = line.substr(1, line.find(']') - 1) + ".";
    result += equals == std::string::npos
                  ? line
                  : line.substr(0, equals) + readable_value(section + line.substr(0, equals), line.substr(equals));
    if (end < effective_scene.size()) result += '\n';
    at = end + 1;
  }
  return result;
}

}  // namespace clogflow
