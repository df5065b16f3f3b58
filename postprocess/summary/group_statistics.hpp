// All numbers of one ensemble as JSON; keys are documented in postprocess/README.md.
#pragma once

#include <nlohmann/json.hpp>

#include "postprocess/events/run_groups.hpp"
#include "postprocess/summary/event_statistics.hpp"

namespace clogflow::postprocess {

nlohmann::json group_statistics(const RunGroup& group, const StatisticsRequest& request);

}  // namespace clogflow::postprocess
