// The reference of scene keys in the forms that people and programs read.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "coupling/keys/key_reference.hpp"

namespace clogflow {

/// For a terminal: a paragraph a key, under a line a section.
std::string keys_as_text(const std::vector<KeyEntry>& entries);

/// The page docs/keys.md: a table a section.
std::string keys_as_page(const std::vector<KeyEntry>& entries);

/// {"keys": [{"name": ..., "kind": ..., "unit": ..., "allowed": [...], "bounds": ..., "default": ..., ...}]}
nlohmann::ordered_json keys_as_json(const std::vector<KeyEntry>& entries);

/// A JSON schema (draft 7) of a scene, for editors. It knows names, kinds, words and signs; what a unit measures,
/// bounds of quantities, and what keys must agree in, only the program knows.
nlohmann::ordered_json scene_schema();

}  // namespace clogflow
