// stats.json; its keys are documented in postprocess/README.md.
#pragma once

#include <nlohmann/json.hpp>

#include "postprocess/summary/statistics.hpp"

namespace clogflow::postprocess {

nlohmann::json as_json(const Statistics& statistics);

}  // namespace clogflow::postprocess
