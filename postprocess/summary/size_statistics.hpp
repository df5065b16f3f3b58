// Which particles passed, where they differ: their sizes, and the passages of each species.
#pragma once

#include <optional>
#include <vector>

#include "postprocess/events/run_groups.hpp"
#include "postprocess/laws/confidence.hpp"

namespace clogflow::postprocess {

struct SpeciesStatistics {
  double diameter = 0;     ///< mean asked for [m]
  double density = 0;      ///< [kg/m3]
  double feed_share = 0;   ///< of the number that comes in, as the scene says [-]
  double passages = 0;     ///< in the windows, those while friction was off included
  Estimate passage_share;  ///< of all passages [-]
};

struct SizeStatistics {
  double feed_diameter = 0;   ///< mean over number that the scene says [m]
  double feed_spread = 0;     ///< standard deviation over mean [-]
  Estimate passage_diameter;  ///< mean over the passages [m]
  std::vector<SpeciesStatistics> species;
};

/// Nothing where all particles are equal, or no passage says its size. Intervals resample the seeds.
std::optional<SizeStatistics> size_statistics(const RunGroup& group, const Resampling& resampling);

}  // namespace clogflow::postprocess
