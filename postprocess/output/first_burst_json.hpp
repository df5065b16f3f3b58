// The first bursts and the order of the later ones as JSON, for stats.json.
#pragma once

#include <nlohmann/json.hpp>

#include "postprocess/summary/burst_order.hpp"
#include "postprocess/summary/first_burst_statistics.hpp"

namespace clogflow::postprocess {

/// seeds, clogged, cut_off, passages, largest, jammed_starts; mean with restricted_to (null: the whole mean); hazard,
/// hazard_bins[]; geometric; packing_near_neck; clog_places.
nlohmann::json as_json(const FirstBurstStatistics& statistics);

/// bursts, fifths[], trend, memory, depends, verdict.
nlohmann::json as_json(const BurstOrder& order);

}  // namespace clogflow::postprocess
