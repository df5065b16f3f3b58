// What the JSON of verbs has in common.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace clogflow::cli {

/// {"format": "clogflow NAME", "version": 1, "program": ...}: names of members stay, new ones may come.
nlohmann::json json_head(const std::string& name);

/// null where it is no finite number.
nlohmann::json number_or_null(double value);

/// Every key with its value as people write it, quantities as texts with their unit: {"geometry.neck_width": "100 um"}.
nlohmann::json scene_json(const std::string& effective_scene);

}  // namespace clogflow::cli
