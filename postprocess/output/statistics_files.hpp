// The whole of `clog stats`: run files in, stats.json and tables out.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "postprocess/summary/statistics.hpp"

namespace clogflow::postprocess {

struct StatisticsJob {
  std::vector<std::filesystem::path> folders;
  std::filesystem::path out;
  std::optional<double> threshold;  ///< T_min [s]; absent: tau/2
  StatisticsRequest request;
};

/// Writes stats.json and the tables into `out`, which it creates. \return what they hold
/// \throws Error as gather, or when a file cannot be written
Statistics write_statistics(const StatisticsJob& job);

}  // namespace clogflow::postprocess
