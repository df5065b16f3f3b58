// TOML text and --set overrides into a draft: every key known, every single value checked.
#include "coupling/scene/scene_draft.hpp"

#include <algorithm>
#include <memory>
#include <vector>

#include "coupling/base/require.hpp"
#include "coupling/base/shown_text.hpp"
#include "coupling/scene/scene_bounds.hpp"
#include "coupling/scene/scene_keys.hpp"
#include "coupling/scene/scene_value.hpp"

namespace clogflow {
namespace {

struct Leaf {
  std::string path;
  const toml::node* value;
  std::uint32_t line;
};

[[noreturn]] void refuse_unknown(const std::string& where, const std::string& path, const std::string& shown) {
  throw Error(fmt::format("{}: {} = {} ({})", where, shown_text(path), shown, unknown_key(path)));
}

// Tables in a TOML library are sorted by name; messages and printing want the order of the file.
void collect(const toml::table& table, const std::string& prefix, std::vector<Leaf>& leaves) {
  for (const auto& [name, node] : table) {
    const std::string path = prefix + std::string(name.str());
    const std::uint32_t line =
        node.is_table() && !node.as_table()->is_inline() ? node.source().begin.line : name.source().begin.line;
    if (is_section(path) && node.is_table()) {
      leaves.push_back({path, nullptr, line});
      collect(*node.as_table(), path + ".", leaves);
    } else {
      leaves.push_back({path, &node, line});
    }
  }
}

struct Placed {
  std::string where;
  std::string path;
  const toml::node* value;  // nullptr: a section
};

void set_leaf(const Placed& leaf, SceneDraft& draft) {
  draft.sections.insert(std::string(section_of(leaf.path)));
  if (!leaf.value) {
    draft.sections.insert(leaf.path);
    return;
  }
  const std::string shown = shown_value(*leaf.value);
  if (is_section(leaf.path))
    throw Error(fmt::format("{}: {} = {} (a section: write [{}] on a line of its own)", leaf.where, leaf.path, shown,
                            leaf.path));
  const Key* key = find_key(leaf.path);
  if (!key) refuse_unknown(leaf.where, leaf.path, shown);
  try {
    set_value(*key, *leaf.value, draft.scene);
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", leaf.where, error.what()));
  }
  draft.given[leaf.path] = {leaf.where, shown};
}

toml::table parse_document(const std::string& text, const std::string& name) {
  check_scene_text(text, name);
  try {
    return toml::parse(text, name);
  } catch (const toml::parse_error& error) {
    throw Error(fmt::format("{}:{}: {}", name, error.source().begin.line, shown_text(error.description())));
  }
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

// "key=value"; what is no TOML value stands for itself as text, so that a shell needs no quotes.
struct Override {
  std::string path;
  toml::table holder;

  explicit Override(const std::string& text) {
    const std::size_t equals = text.find('=');
    require(equals != std::string::npos && equals > 0,
            "--set {} (write key=value, e.g. --set particles.diameter=\"33 um\")", shown_text(text));
    path = trimmed(text.substr(0, equals));
    const std::string value = trimmed(text.substr(equals + 1));
    check_scene_text(value, "--set " + shown_text(text));
    try {
      holder = toml::parse("value = " + value);
      if (holder.size() == 1 && holder.contains("value")) return;
    } catch (const toml::parse_error&) {
    }
    holder = toml::table{};
    holder.insert("value", value);
  }
  const toml::node& value() const { return *holder.get("value"); }
};

}  // namespace

std::string SceneDraft::says(std::string_view key) const {
  const auto found = given.find(key);
  if (found != given.end()) return fmt::format("{}: {} = {}", found->second.where, key, found->second.shown);
  const Key* known = find_key(key);
  Scene copy = scene;
  if (const auto* number = known ? std::get_if<NumberSlot>(&known->slot) : nullptr)
    return fmt::format("{}: {} = {} by default", name, key, format_quantity(number->at(copy), number->dimension));
  return fmt::format("{}: {}", name, key);
}

SceneDraft read_draft(const std::string& text, const std::string& name, const Overrides& overrides) {
  SceneDraft draft{.name = name};
  const toml::table document = parse_document(text, name);
  std::vector<Leaf> leaves;
  collect(document, "", leaves);
  std::ranges::stable_sort(leaves, {}, &Leaf::line);

  std::vector<Override> replacements;
  for (const std::string& override : overrides) replacements.emplace_back(override);
  for (const Leaf& leaf : leaves) {
    // A value that an override replaces is not judged: it may be there to be replaced.
    const bool replaced =
        std::ranges::any_of(replacements, [&](const Override& other) { return other.path == leaf.path; });
    if (!replaced) set_leaf({fmt::format("{}:{}", name, leaf.line), leaf.path, leaf.value}, draft);
  }
  for (std::size_t i = 0; i < replacements.size(); ++i)
    set_leaf({"--set " + shown_text(overrides[i]), replacements[i].path, &replacements[i].value()}, draft);
  return draft;
}

}  // namespace clogflow
