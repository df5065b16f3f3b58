// trade.json, read back for --combine.
#pragma once

#include <filesystem>

#include <nlohmann/json.hpp>

namespace clogflow::trade {

/// \throws Error naming the file, unless it holds what `combine` asks of a study
nlohmann::json read_study(const std::filesystem::path& file);

}  // namespace clogflow::trade
