// All that the run files of some folders say: what stats.json holds.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "postprocess/summary/group_statistics.hpp"
#include "postprocess/summary/trend.hpp"

namespace clogflow::postprocess {

struct Statistics {
  std::vector<RunGroup> groups;
  std::vector<GroupStatistics> numbers;  ///< of each group
  std::vector<std::string> swept_keys;
  Trend trend;
  std::vector<std::string> without_runs;  ///< points of a sweep that hold no run file yet
  Resampling resampling;                  ///< of all intervals
};

/// \param threshold T_min [s]; absent: tau/2 \throws Error as gather
Statistics statistics_of(const std::vector<std::filesystem::path>& folders, std::optional<double> threshold,
                         const StatisticsRequest& request);

}  // namespace clogflow::postprocess
