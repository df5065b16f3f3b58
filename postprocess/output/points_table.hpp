// points.csv: one row an ensemble, the numbers that a sweep is about.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace clogflow::postprocess {

/// \param statistics what stats.json holds, `trend` included
std::string points_table(const nlohmann::json& statistics);

}  // namespace clogflow::postprocess
