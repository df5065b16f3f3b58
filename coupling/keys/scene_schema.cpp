// The JSON schema of a scene: each kind of value has one form.
#include <cmath>

#include <fmt/format.h>

#include "coupling/keys/key_prints.hpp"

namespace clogflow {
namespace {

using Json = nlohmann::ordered_json;

// A number and a unit that begins with a letter, "1/" for a rate, or "%": what it measures is not looked at.
Json quantity(const std::string& sign) {
  return {{"type", "string"},
          {"pattern", "^\\s*" + sign + "([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][+-]?[0-9]+)?\\s*(1/)?[A-Za-z]"}};
}

Json with_range(Json type, const Range& range) {
  if (std::isfinite(range.low)) type[range.low_allowed ? "minimum" : "exclusiveMinimum"] = range.low;
  if (std::isfinite(range.high)) type[range.high_allowed ? "maximum" : "exclusiveMaximum"] = range.high;
  return type;
}

Json three(const Json& item) { return {{"type", "array"}, {"items", item}, {"minItems", 3}, {"maxItems", 3}}; }

Json table(Json properties) {
  return {{"type", "object"}, {"additionalProperties", false}, {"properties", std::move(properties)}};
}

Json friction_of_species() {
  const Json coefficient{{"type", "number"}, {"minimum", 0}};
  return table({{"sliding", coefficient}, {"rolling", coefficient}, {"torsion", coefficient}});
}

struct Schema {
  Json operator()(const NumberSlot& slot) const {
    if (slot.dimension == dimension::number) return with_range({{"type", "number"}}, slot.range);
    return quantity(slot.range.low >= 0 ? "\\+?" : "[+-]?");
  }
  Json operator()(const AngleSlot&) const { return quantity("\\+?"); }
  Json operator()(const VectorSlot& slot) const {
    const Json item = quantity("[+-]?");
    if (slot.dimension != dimension::velocity) return three(item);
    return {{"anyOf", Json::array({item, three(item)})}};
  }
  Json operator()(const CountSlot& slot) const { return with_range({{"type", "integer"}}, slot.range); }
  Json operator()(const SwitchSlot&) const { return {{"type", "boolean"}}; }
  Json operator()(const TextSlot&) const { return {{"type", "string"}}; }
  Json operator()(const WordSlot& slot) const { return {{"type", "string"}, {"enum", slot.words}}; }
  Json operator()(const TextsSlot&) const { return {{"type", "array"}, {"items", {{"type", "string"}}}}; }
  Json operator()(const SeedsSlot&) const {
    const Json seed{{"type", "integer"}, {"minimum", 0}};
    const Json text{{"type", "string"}, {"pattern", "^[0-9, -]+$"}};
    return {{"anyOf", Json::array({text, seed, {{"type", "array"}, {"items", seed}}})}};
  }
  Json operator()(const SpeciesSlot&) const {
    Json kind = table({{"diameter", quantity("\\+?")},
                       {"share", {{"type", "number"}, {"exclusiveMinimum", 0}}},
                       {"density", quantity("\\+?")},
                       {"friction", friction_of_species()},
                       {"wall_friction", friction_of_species()}});
    kind["required"] = {"diameter", "share"};
    return {{"type", "array"}, {"items", kind}, {"minItems", 1}, {"maxItems", most_species}};
  }
};

// The place of a key in the tree, whose tables are made on the way.
Json& place(Json& root, std::string_view path) {
  Json* here = &root;
  for (std::size_t dot; (dot = path.find('.')) != std::string_view::npos; path = path.substr(dot + 1)) {
    Json& section = (*here)["properties"][std::string(path.substr(0, dot))];
    if (section.is_null()) section = table(Json::object());
    here = &section;
  }
  return (*here)["properties"][std::string(path)];
}

}  // namespace

nlohmann::ordered_json scene_schema() {
  Json schema{{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", "a clogflow scene"}};
  schema.update(table(Json::object()));
  for (const Key& key : scene_keys()) {
    const KeyEntry entry = describe(key);
    Json value = std::visit(Schema{}, key.slot);
    std::string text = entry.meaning;
    if (!entry.bounds.empty())
      text += fmt::format(" ({}{}{})", entry.bounds, entry.unit.empty() ? "" : " ", entry.unit);
    value["description"] = text + "; " + entry.fallback_words();
    place(schema, key.path) = std::move(value);
  }
  for (auto& [name, section] : schema["properties"].items())
    if (const std::string_view meaning = section_meaning(name); section.contains("properties") && !meaning.empty())
      section["description"] = meaning;
  return schema;
}

}  // namespace clogflow
