// The object `trend` of stats.json; its keys are documented in postprocess/README.md.
#pragma once

#include <nlohmann/json.hpp>

#include "postprocess/summary/trend.hpp"

namespace clogflow::postprocess {

nlohmann::json as_json(const Trend& trend);

}  // namespace clogflow::postprocess
