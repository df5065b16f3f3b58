// Each kind of scene value has one reader, which says what it wants when it gets something else.
#include "coupling/scene/scene_value.hpp"

#include <cmath>
#include <sstream>

#include "coupling/base/require.hpp"
#include "coupling/base/shown_text.hpp"

namespace clogflow {
namespace {

// A value in a message: the place it came from is added by the caller.
struct Reader {
  const Key& key;
  Scene& scene;

  [[noreturn]] void refuse(const std::string& name, const toml::node& value, const std::string& reason) const {
    throw Error(fmt::format("{} = {} ({})", name, shown_value(value), reason));
  }

  double finite(const std::string& name, const toml::node& value) const {
    const double number = *value.value<double>();
    if (!std::isfinite(number)) refuse(name, value, "must be a finite number");
    return number;
  }

  double pure_number(const std::string& name, const toml::node& value) const {
    if (value.is_string() && value.as_string()->get().find(',') != std::string::npos)
      refuse(name, value, "must be a pure number, with a decimal point and no comma, e.g. 0.6");
    if (value.is_string()) refuse(name, value, "must be a pure number, written without quotes and unit, e.g. 0.6");
    if (!value.is_number()) refuse(name, value, "must be a pure number, e.g. 0.6");
    return finite(name, value);
  }

  Quantity quantity(const std::string& name, const toml::node& value, const QuantityWords& words) const {
    const std::string missing = fmt::format("{} needs a unit, e.g. \"{}\"", words.name, words.example);
    if (value.is_number()) refuse(name, value, missing);
    if (!value.is_string()) refuse(name, value, fmt::format("must be {}, e.g. \"{}\"", words.name, words.example));
    const std::string& text = value.as_string()->get();
    if (!text.empty() && text.find_first_not_of("0123456789+-.eE ") == std::string::npos) refuse(name, value, missing);
    try {
      return parse_quantity(text);
    } catch (const Error& error) {
      throw Error(fmt::format("{} = {}", name, error.what()));
    }
  }

  double number(const std::string& name, const toml::node& value, Dimension dimension) const {
    if (dimension == dimension::number) return pure_number(name, value);
    const QuantityWords wanted = quantity_words(dimension);
    const Quantity quantity = this->quantity(name, value, wanted);
    if (quantity.dimension != dimension) {
      const std::string got = quantity.is_angle ? "an angle" : quantity_words(quantity.dimension).name;
      refuse(name, value, fmt::format("{}, but {} is needed, e.g. \"{}\"", got, wanted.name, wanted.example));
    }
    return quantity.si;
  }

  void operator()(const NumberSlot& slot, const toml::node& value) const {
    const std::string name(key.path);
    const double number = this->number(name, value, slot.dimension);
    if (!slot.range.contains(number)) refuse(name, value, slot.range.words());
    slot.at(scene) = number;
  }

  void operator()(const AngleSlot& slot, const toml::node& value) const {
    const std::string name(key.path);
    const Quantity angle = quantity(name, value, {"an angle", "60 deg"});
    if (!angle.is_angle)
      refuse(name, value,
             fmt::format("{}, but an angle is needed, e.g. \"60 deg\"", quantity_words(angle.dimension).name));
    if (!(angle.si > 0 && angle.si <= largest_half_angle)) refuse(name, value, "must be in (0 deg, 90 deg]");
    slot.at(scene) = angle.si;
  }

  void operator()(const VectorSlot& slot, const toml::node& value) const {
    const std::string name(key.path);
    const toml::array* components = value.as_array();
    const bool along_x = slot.dimension == dimension::velocity && !components;
    if (along_x) {
      slot.at(scene) = {number(name, value, slot.dimension), 0, 0};
      return;
    }
    const QuantityWords words = quantity_words(slot.dimension);
    if (!components || components->size() != 3)
      refuse(name, value,
             fmt::format("must be three values in brackets, each {0}, e.g. [\"{1}\", \"{1}\", \"{1}\"]", words.name,
                         words.example));
    for (std::size_t i = 0; i < 3; ++i)
      slot.at(scene)[i] = number(fmt::format("{}[{}]", name, i), *components->get(i), slot.dimension);
  }

  void operator()(const CountSlot& slot, const toml::node& value) const {
    const std::string name(key.path);
    if (!value.is_integer()) refuse(name, value, "must be a whole number, e.g. 3");
    const std::int64_t count = value.as_integer()->get();
    if (!slot.range.contains(static_cast<double>(count))) refuse(name, value, slot.range.words());
    slot.at(scene) = static_cast<int>(count);
  }

  void operator()(const SwitchSlot& slot, const toml::node& value) const {
    if (!value.is_boolean()) refuse(std::string(key.path), value, "must be true or false");
    slot.at(scene) = value.as_boolean()->get();
  }

  void operator()(const TextSlot& slot, const toml::node& value) const {
    if (!value.is_string()) refuse(std::string(key.path), value, "must be a text in quotes");
    slot.at(scene) = value.as_string()->get();
  }

  void operator()(const WordSlot& slot, const toml::node& value) const {
    std::string allowed;
    for (std::size_t i = 0; i < slot.words.size(); ++i) {
      if (value.is_string() && value.as_string()->get() == slot.words[i]) {
        slot.set(scene, static_cast<int>(i));
        return;
      }
      const char* separator = i == 0 ? "" : i + 1 == slot.words.size() ? " or " : ", ";
      allowed += fmt::format("{}\"{}\"", separator, slot.words[i]);
    }
    refuse(std::string(key.path), value, "must be " + allowed);
  }

  void operator()(const TextsSlot& slot, const toml::node& value) const {
    const char* allowed = "must be texts in quotes: [\"one\", \"two\"]";
    slot.at(scene).clear();
    if (!value.is_array()) refuse(std::string(key.path), value, allowed);
    for (const toml::node& text : *value.as_array()) {
      if (!text.is_string()) refuse(std::string(key.path), value, allowed);
      slot.at(scene).push_back(text.as_string()->get());
    }
  }

  Friction friction(const std::string& name, const toml::node& value) const {
    const toml::table* table = value.as_table();
    if (!table || table->empty())
      refuse(name, value, "must be coefficients, e.g. {sliding = 0.3, rolling = 0.1}; those left out are common");
    Friction read = common_friction;
    for (const auto& [field, node] : *table) {
      const std::string path = fmt::format("{}.{}", name, field.str());
      double Friction::*const member = field.str() == "sliding"   ? &Friction::sliding
                                       : field.str() == "rolling" ? &Friction::rolling
                                       : field.str() == "torsion" ? &Friction::torsion
                                                                  : nullptr;
      if (!member) refuse(path, node, "unknown: friction has sliding, rolling and torsion");
      read.*member = number(path, node, dimension::number);
      if (!(read.*member >= 0)) refuse(path, node, "must be >= 0");
    }
    return read;
  }

  Species species(const std::string& name, const toml::node& value) const {
    const toml::table* table = value.as_table();
    if (!table) refuse(name, value, "must be a kind of particles: {diameter = \"33 um\", share = 0.5}");
    Species kind;
    for (const auto& [field, node] : *table) {
      const std::string path = fmt::format("{}.{}", name, field.str());
      if (field.str() == "friction" || field.str() == "wall_friction") {
        (field.str() == "friction" ? kind.friction : kind.wall_friction) = friction(path, node);
        continue;
      }
      double value_read = 0;
      if (field.str() == "diameter") {
        value_read = kind.diameter = number(path, node, dimension::length);
      } else if (field.str() == "share") {
        value_read = kind.share = number(path, node, dimension::number);
      } else if (field.str() == "density") {
        value_read = kind.density = number(path, node, dimension::density);
      } else {
        refuse(path, node,
               "unknown: a species has diameter, share, density, friction and wall_friction; all else is common");
      }
      if (!(value_read > 0)) refuse(path, node, "must be > 0");
    }
    if (kind.diameter == 0) refuse(name, value, "has no diameter: give it, e.g. diameter = \"33 um\"");
    if (kind.share == 0) refuse(name, value, "has no share of the number of particles: give it, e.g. share = 0.5");
    return kind;
  }

  void operator()(const SpeciesSlot& slot, const toml::node& value) const {
    const std::string name(key.path);
    const toml::array* kinds = value.as_array();
    if (!kinds || kinds->empty() || kinds->size() > most_species)
      refuse(name, value,
             fmt::format("must be a list of kinds: [{{diameter = \"33 um\", share = 0.5}}, ...], at most {}",
                         most_species));
    slot.at(scene).clear();
    double sum = 0;
    for (std::size_t i = 0; i < kinds->size(); ++i) {
      slot.at(scene).push_back(species(fmt::format("{}[{}]", name, i), *kinds->get(i)));
      sum += slot.at(scene).back().share;
    }
    if (std::abs(sum - 1) > 1e-6) refuse(name, value, fmt::format("shares must add up to 1, these to {:.7g}", sum));
  }

  void operator()(const SeedsSlot& slot, const toml::node& value) const {
    const std::string name(key.path);
    std::string text;
    if (value.is_string()) {
      text = value.as_string()->get();
    } else if (value.is_integer()) {
      text = std::to_string(value.as_integer()->get());
    } else if (value.is_array()) {
      for (const toml::node& seed : *value.as_array()) {
        if (!seed.is_integer()) refuse(name, value, "must be whole numbers, e.g. [1, 2, 3] or \"1-40\"");
        text += fmt::format("{}{}", text.empty() ? "" : ",", seed.as_integer()->get());
      }
    } else {
      refuse(name, value, "must be whole numbers, e.g. [1, 2, 3] or \"1-40\"");
    }
    try {
      slot.at(scene) = parse_seeds(text);
    } catch (const Error& error) {
      throw Error(fmt::format("{} = {}", name, error.what()));
    }
  }
};

}  // namespace

namespace {

std::string whole_text(const toml::node& value) {
  if (value.is_string()) return fmt::format("\"{}\"", value.as_string()->get());
  if (value.is_floating_point()) return fmt::format("{}", value.as_floating_point()->get());
  if (value.is_table()) return "{...}";
  if (const toml::array* array = value.as_array()) {
    std::string text;
    for (const toml::node& item : *array) text += (text.empty() ? "" : ", ") + whole_text(item);
    return "[" + text + "]";
  }
  std::ostringstream stream;
  value.visit([&stream](const auto& node) { stream << node; });
  return stream.str();
}

}  // namespace

std::string shown_value(const toml::node& value) {
  constexpr std::size_t longest = 80;
  return shown_text(whole_text(value), longest);
}

void set_value(const Key& key, const toml::node& value, Scene& scene) {
  std::visit([&](const auto& slot) { Reader{key, scene}(slot, value); }, key.slot);
}

}  // namespace clogflow
