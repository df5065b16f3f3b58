// All numbers of one ensemble.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "postprocess/events/run_groups.hpp"
#include "postprocess/summary/burst_order.hpp"
#include "postprocess/summary/event_statistics.hpp"
#include "postprocess/summary/first_burst_statistics.hpp"
#include "postprocess/summary/quantities.hpp"
#include "postprocess/summary/size_statistics.hpp"

namespace clogflow::postprocess {

/// A quantity in the two halves of the runs.
struct Ageing {
  Estimate first_half, second_half;
  Estimate change;             ///< second minus first
  std::optional<bool> drifts;  ///< whether the interval of the change excludes 0; absent without an interval
};

struct QuantityStatistics {
  const Quantity* quantity = nullptr;
  Estimate whole;
  std::optional<Ageing> halves;  ///< absent for what only the end of a run shows
};

/// Means over the second half of the windows.
struct SteadyStatistics {
  Estimate particles, packing_fraction;
  std::vector<Estimate> porosity;  ///< one a strip
};

struct GroupStatistics {
  std::string label;                           ///< what tells it from the other ensembles
  std::vector<QuantityStatistics> quantities;  ///< in the order of the table of quantities
  FirstBurstStatistics first_burst;
  std::optional<BurstOrder> burst_order;  ///< of runs that clear their clogs
  BurstShape bursts;
  LapseCounts lapses;
  PowerLaws power_laws;
  SteadyStatistics steady;
  std::vector<GroupStatistics> necks;   ///< of each neck of several, in order of y: its own passages, bursts, arrests
  std::optional<SizeStatistics> sizes;  ///< where particles differ
  std::vector<std::string> notes;       ///< what a reader must know of these runs

  /// \param key of the table of quantities
  const QuantityStatistics& of(const std::string& key) const;
};

/// Why `<s>` over whole bursts (mean_burst) is too small: the end of a run cuts long bursts more often than short ones.
/// Nothing where the mean of every passage and every clog lies within its interval and few bursts were cut.
std::string cut_off_words(const GroupStatistics& numbers);

/// Without a label, which depends on the other ensembles.
GroupStatistics group_statistics(const RunGroup& group, const StatisticsRequest& request);

}  // namespace clogflow::postprocess
