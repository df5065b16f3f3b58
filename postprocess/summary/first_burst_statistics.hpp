// What the first, free bursts of an ensemble say: one a seed.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "postprocess/events/run_groups.hpp"
#include "postprocess/laws/hazard.hpp"
#include "postprocess/laws/restricted_mean.hpp"
#include "postprocess/laws/survival.hpp"
#include "postprocess/summary/event_statistics.hpp"

namespace clogflow::postprocess {

/// Solids near the neck: a mean burst belongs to a packing, and to no other.
struct PackingNearNeck {
  Estimate flowing, at_end;  ///< over seeds [-]
};

/// Where the first clogs stood. One more than a neck width upstream of the neck's entrance is not the neck's.
struct ClogPlaces {
  std::size_t known = 0;     ///< clogs whose place the runs say
  std::size_t upstream = 0;  ///< of them, those that are not the neck's
  Estimate share_upstream;   ///< exact interval
};

struct FirstBurstStatistics {
  std::size_t seeds = 0, clogged = 0;  ///< the end of the run cut the others
  std::size_t passages = 0, largest = 0;
  std::size_t jammed_starts = 0;  ///< seeds that were to flow before the start, and jammed
  MeanCount mean;                 ///< passages until the first clog
  Estimate hazard;                ///< per passage, as if it never changed
  std::vector<HazardBin> hazard_bins;
  std::vector<SurvivalStep> survival;      ///< in passages
  std::optional<GeometricTest> geometric;  ///< absent where no seed clogged
  Verdict verdict;                         ///< on the geometric law
  std::optional<MemorylessTail> tail;      ///< of a law that is ruled out as a whole, if there is one
  PackingNearNeck packing;
  ClogPlaces places;
};

/// Clogs that a memoryless tail must hold: fewer rule nothing out.
inline constexpr std::size_t events_of_memoryless_tail = 20;

/// For the laws of counts: one a seed.
std::vector<TrialCount> first_bursts(const RunGroup& group);

FirstBurstStatistics first_burst_statistics(const RunGroup& group, const StatisticsRequest& request);

}  // namespace clogflow::postprocess
