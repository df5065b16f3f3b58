// Text, page and JSON of the key reference.
#include "coupling/keys/key_prints.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace clogflow {
namespace {

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}

// In a cell of a table.
std::string cell(const std::string& text) { return replaced(replaced(text, "|", "\\|"), "*", "\\*"); }

std::string kind_and_unit(const KeyEntry& entry) {
  return entry.unit.empty() ? entry.kind : fmt::format("{} [{}]", entry.kind, entry.unit);
}

std::string heading(const std::string& section) { return section.empty() ? "Before the first section" : section; }

}  // namespace

std::string keys_as_text(const std::vector<KeyEntry>& entries) {
  std::string text;
  const std::string* section = nullptr;
  for (const KeyEntry& entry : entries) {
    if (section == nullptr || *section != entry.section)
      text += entry.section.empty() ? fmt::format("{}\n\n", heading(""))
                                    : fmt::format("[{}]  {}\n\n", entry.section, section_meaning(entry.section));
    section = &entry.section;
    text += fmt::format("{}\n    {}\n", entry.name, entry.meaning);
    const std::string allowed = entry.allowed();
    text += fmt::format("    {}{}{}; {}; e.g. {}\n\n", kind_and_unit(entry), allowed.empty() ? "" : ", ", allowed,
                        entry.fallback_words(), entry.example);
  }
  return text;
}

std::string keys_as_page(const std::vector<KeyEntry>& entries) {
  std::string page =
      "# Scene reference\n\n"
      "Every key of a scene, as `clog keys` prints it; this page is made by `clog keys --page`. A quantity is a text "
      "with\n"
      "its unit (`\"33 um\"`), a pure number is bare (`0.6`). Bounds are in the SI unit in brackets. A section that "
      "is\n"
      "absent is off or at its defaults. `clog keys NAME` looks one key or section up, and `clog info SCENE` prints a\n"
      "scene with every default filled in. Editors: [A schema for your editor](editors.md).\n";
  const std::string* section = nullptr;
  for (const KeyEntry& entry : entries) {
    if (section == nullptr || *section != entry.section) {
      page += fmt::format("\n## {}\n\n", heading(entry.section));
      if (!entry.section.empty())
        page += fmt::format("Section `[{}]`: {}.\n\n", entry.section, section_meaning(entry.section));
      page += "| key | is | value | default |\n| --- | --- | --- | --- |\n";
    }
    section = &entry.section;
    const std::string allowed = entry.allowed();
    page += fmt::format("| `{}` | {} | {}{}{}, as `{}` | {} |\n", entry.name, cell(entry.meaning),
                        cell(kind_and_unit(entry)), allowed.empty() ? "" : ", ", cell(allowed), entry.example,
                        cell(entry.fallback));
  }
  return page;
}

nlohmann::ordered_json keys_as_json(const std::vector<KeyEntry>& entries) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const KeyEntry& entry : entries) {
    nlohmann::ordered_json key{{"name", entry.name}, {"section", entry.section}, {"kind", entry.kind}};
    if (!entry.unit.empty()) key["unit"] = entry.unit;
    if (!entry.words.empty()) key["allowed"] = entry.words;
    if (!entry.bounds.empty()) key["bounds"] = entry.bounds;
    key["default"] = entry.fallback;
    key["required"] = entry.required();
    key["meaning"] = entry.meaning;
    key["example"] = entry.example;
    list.push_back(std::move(key));
  }
  return {{"keys", list}};
}

}  // namespace clogflow
