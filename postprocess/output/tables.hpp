// The CSV tables: every event and every distribution, units in the header.
#pragma once

#include <string>
#include <vector>

#include "postprocess/events/run_groups.hpp"

namespace clogflow::postprocess {

/// A table as text under its file name; the column `group` is the index in stats.json.
struct Table {
  std::string file;
  std::string text;
};

/// A number, or nothing where it is not known.
std::string cell(double value);

/// lapses, bursts, arrests, burst_distribution, lapse_distribution, lapse_survival,
/// arrest_survival, first_bursts, first_burst_survival, first_burst_hazard.
std::vector<Table> tables_of(const std::vector<RunGroup>& groups);

}  // namespace clogflow::postprocess
