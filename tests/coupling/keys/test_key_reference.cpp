// What the reference says of a key is what the program does.
#include "coupling/keys/key_reference.hpp"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../scene/scene_texts.hpp"
#include "coupling/base/require.hpp"
#include "coupling/keys/key_prints.hpp"
#include "coupling/scene/scene_draft.hpp"

namespace clogflow {
namespace {

using testing::HasSubstr;
using testing::Not;

KeyEntry of(std::string_view name) { return describe(*find_key(name)); }

TEST(KeyReference, TakesARowApart) {
  const KeyEntry cells = of("flow.mesh_cells_per_neck");
  EXPECT_EQ(cells.section, "flow");
  EXPECT_EQ(cells.kind, "number");
  EXPECT_EQ(cells.unit, "");
  EXPECT_EQ(cells.bounds, "in [4, 400]");
  EXPECT_EQ(cells.fallback, "48");
  EXPECT_EQ(cells.meaning, "mesh cells across the full neck width");
  const KeyEntry viscosity = of("fluid.viscosity");
  EXPECT_EQ(viscosity.kind, "viscosity");
  EXPECT_EQ(viscosity.unit, "Pa s");
  EXPECT_EQ(viscosity.allowed(), "> 0");
  EXPECT_THAT(viscosity.fallback, HasSubstr("required for drag"));
  const KeyEntry lookup = of("flow.lookup");
  EXPECT_EQ(lookup.allowed(), "\"nearest\" or \"trilinear\"");
  EXPECT_EQ(lookup.fallback, "nearest");  // which its row does not name
  EXPECT_EQ(of("gravity").section, "");
  EXPECT_EQ(of("gravity").unit, "m/s2");
  EXPECT_EQ(of("geometry.stl").fallback, "none");
}

TEST(KeyReference, EveryKeyAndSectionHasAMeaning) {
  for (const KeyEntry& entry : entries_of("")) {
    EXPECT_GT(entry.meaning.size(), 5u) << entry.name;
    EXPECT_THAT(entry.meaning, Not(testing::StartsWith("default"))) << entry.name << ": \"meaning; default ...\"";
    EXPECT_FALSE(entry.kind.empty() || entry.fallback.empty() || entry.example.empty()) << entry.name;
    EXPECT_FALSE(section_meaning(entry.section).empty()) << "no meaning of section " << entry.section;
  }
  EXPECT_EQ(entries_of("").size(), scene_keys().size());
}

// The draft alone: whether values fit each other is asked of whole scenes.
TEST(KeyReference, EveryExampleIsTaken) {
  for (const KeyEntry& entry : entries_of("")) {
    const std::string in_section = entry.name.substr(entry.section.empty() ? 0 : entry.section.size() + 1);
    const std::string section = entry.section.empty() ? "" : "[" + entry.section + "]\n";
    EXPECT_NO_THROW(read_draft(section + in_section + " = " + entry.example + "\n", "scene", {})) << entry.name;
  }
}

// A scene with every section and nothing in it but what is required.
std::string bare_scene() { return channel + "[output]\n[unclog]\n[passages]\n[ensemble]\n[fidelity]\n"; }

TEST(KeyReference, DefaultsThatAreStatedAreThoseOfTheProgram) {
  Scene scene = parse_scene(bare_scene(), "bare");
  const std::set<std::string_view> given{"contact.restitution", "contact.friction.sliding"};
  // What holds only where something else is chosen: tested with it, in test_scene.
  const std::set<std::string_view> depends{"inlet.strain", "unclog.strain"};
  int compared = 0;
  for (const Key& key : scene_keys()) {
    const KeyEntry entry = describe(key);
    if (given.contains(key.path) || depends.contains(key.path)) continue;
    const std::string stated = entry.fallback.substr(0, entry.fallback.find_first_of(" :,;"));
    SCOPED_TRACE(entry.name + ": default " + entry.fallback);
    if (const auto* toggle = std::get_if<SwitchSlot>(&key.slot)) {
      EXPECT_EQ(stated, toggle->at(scene) ? "true" : "false");
    } else if (const auto* word = std::get_if<WordSlot>(&key.slot)) {
      EXPECT_EQ(stated, word->words[static_cast<std::size_t>(word->get(scene))]);
    } else if (const auto* count = std::get_if<CountSlot>(&key.slot)) {
      EXPECT_EQ(stated, std::to_string(count->at(scene)));
    } else if (const auto* number = std::get_if<NumberSlot>(&key.slot)) {
      double value = 0, over = 1;
      if (std::sscanf(entry.fallback.c_str(), "%lf/%lf", &value, &over) < 1) continue;
      const double si = number->dimension == dimension::number || value == 0 ? 1 : number->at(scene) / value;
      if (entry.fallback.find(" neck_width") != std::string::npos) {
        EXPECT_DOUBLE_EQ(number->at(scene), value * scene.geometry.neck_width);
      } else if (entry.fallback.find(" diameter") != std::string::npos) {
        if (number->at(scene) == 0) continue;  // only for another method
        EXPECT_DOUBLE_EQ(number->at(scene), value * scene.particles.diameter);
      } else if (entry.fallback.find(" Stokes times") != std::string::npos) {
        EXPECT_DOUBLE_EQ(number->at(scene), value * scene.stokes_time());
      } else if (number->dimension == dimension::number) {
        EXPECT_DOUBLE_EQ(number->at(scene), value / over);
      } else if (number->at(scene) != 0 && entry.name != "geometry.stl_unit" &&
                 entry.name != "geometry.stl_tolerance") {
        EXPECT_DOUBLE_EQ(si, 1) << "in SI units";
      }
    } else {
      continue;
    }
    ++compared;
  }
  EXPECT_GT(compared, 45);
}

// Which are required is what reading asks for, one after the other.
TEST(KeyReference, WhatIsRequiredIsAskedFor) {
  for (const std::string_view name :
       {"geometry.neck_width", "geometry.half_angle", "fluid.viscosity", "fluid.density", "flow.mean_velocity",
        "particles.diameter", "contact.youngs_modulus", "contact.poisson_ratio", "time.end"}) {
    EXPECT_THAT(of(name).fallback, testing::StartsWith("required")) << name;
    std::string text = channel;
    const std::string line = std::string(name.substr(name.find('.') + 1)) + " = ";
    const std::size_t at = text.find("\n" + line);
    ASSERT_NE(at, std::string::npos) << name;
    text.erase(at, text.find('\n', at + 1) - at);
    try {
      parse_scene(text, "scene");
      ADD_FAILURE() << name << " is not asked for";
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr(std::string(name) + " is missing"));
    }
  }
}

TEST(KeyReference, FindsKeysAndSections) {
  EXPECT_EQ(entries_of("particles.diameter").size(), 1u);
  EXPECT_EQ(entries_of("contact.friction").size(), 3u);
  EXPECT_GT(entries_of("contact").size(), 15u);
}

std::string refusal(std::string_view name) {
  try {
    entries_of(name);
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

TEST(KeyReference, SuggestsWhatIsClose) {
  EXPECT_EQ(refusal("particles.diametre"),
            "no scene key or section is named \"particles.diametre\" (is \"particles.diameter\" meant?)");
  EXPECT_EQ(refusal("lubrication.restitution"),
            "no scene key or section is named \"lubrication.restitution\" (is \"contact.restitution\" meant?)");
  EXPECT_EQ(refusal("contcat"), "no scene key or section is named \"contcat\" (is \"contact\" meant?)");
  EXPECT_EQ(refusal("zzzzzzzzzz"), "no scene key or section is named \"zzzzzzzzzz\" (clog keys lists all)");
}

TEST(KeyPrints, SayTheSameInEachForm) {
  const std::vector<KeyEntry> entries = entries_of("flow.oscillation.shape");
  EXPECT_EQ(keys_as_text(entries),
            "[flow]  the undisturbed flow: where it comes from, how fast, how it changes in time\n\n"
            "flow.oscillation.shape\n    of that factor: the sine, or its sign\n"
            "    word, \"sine\" or \"square\"; default: sine; e.g. \"square\"\n\n");
  EXPECT_THAT(keys_as_page(entries), HasSubstr("| `flow.oscillation.shape` | of that factor: the sine, or its sign | "
                                               "word, \"sine\" or \"square\", as `\"square\"` | sine |\n"));
  const auto key = keys_as_json(entries).at("keys").at(0);
  EXPECT_EQ(key.at("allowed"), (nlohmann::ordered_json{"sine", "square"}));
  EXPECT_EQ(key.at("default"), "sine");
  EXPECT_EQ(key.at("required"), false);
}

TEST(SceneSchema, HoldsEveryKeyAndNothingElse) {
  const auto schema = scene_schema();
  std::size_t leaves = 0;
  const std::function<void(const nlohmann::ordered_json&)> count = [&](const nlohmann::ordered_json& node) {
    for (const auto& [name, child] : node.at("properties").items())
      child.contains("properties") ? count(child) : void(++leaves);
    EXPECT_EQ(node.at("additionalProperties"), false);
  };
  count(schema);
  EXPECT_EQ(leaves, scene_keys().size());
  EXPECT_EQ(schema["properties"]["contact"]["properties"]["restitution"]["minimum"], 1e-3);
}

}  // namespace
}  // namespace clogflow
