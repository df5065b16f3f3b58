// JSON from a file that anybody may have written.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace clogflow {

/// \return a discarded value where the text is no JSON, or nested deeper than any of ours: the
/// library writes and copies a value by calling itself once a level.
nlohmann::json parse_json(const std::string& text);

}  // namespace clogflow
