// points.csv: one row an ensemble, the numbers that a sweep is about.
#pragma once

#include <string>

#include "postprocess/summary/statistics.hpp"

namespace clogflow::postprocess {

std::string points_table(const Statistics& statistics);

}  // namespace clogflow::postprocess
