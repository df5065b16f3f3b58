// All numbers of one ensemble as JSON; keys are documented in postprocess/README.md.
#pragma once

#include <nlohmann/json.hpp>

#include "postprocess/event_statistics.hpp"
#include "postprocess/run_groups.hpp"

namespace clog::postprocess {

nlohmann::json group_statistics(const RunGroup& group, const StatisticsRequest& request);

}  // namespace clog::postprocess
