// Bursts: how many particles escape between two clogs, or after a release.
#pragma once

#include <cstddef>
#include <vector>

#include "postprocess/events/lapses.hpp"

namespace clogflow::postprocess {

/// Where a burst stands in its run: what its size may be used for.
enum class BurstKind {
  whole,    ///< begins after a clog (or release) and ends with one
  first,    ///< begins with the start of the run, not with the end of a clog
  cut_off,  ///< still flowing when the run ended: its size is a lower bound
};

/// "whole", "first", "cut off"
const char* name(BurstKind kind);

struct Burst {
  double start = 0;           ///< first passage; with releases, when friction came back [s]
  double duration = 0;        ///< first to last passage [s]
  std::size_t size = 0;       ///< s, passages with friction on; 0 is possible after a release only
  std::size_t while_off = 0;  ///< passages while that release held friction off; not part of s
  BurstKind kind = BurstKind::whole;
};

/// Passages without a lapse of T_min or more between them (paper, appendix B): a clog is a lapse
/// T >= T_min. A first burst that never ended counts as cut off.
/// \param threshold T_min [s]
std::vector<Burst> bursts_between_clogs(const RunData& run, const Window& window, double threshold);

/// One burst a release, zeros included: what passes from the return of friction to the next
/// release, preceded by the first burst, which no release began. The last one is whole if nothing
/// passed for `rest` before the run ended. \param rest unclog.after: how long nothing must pass
/// before a release [s]
std::vector<Burst> bursts_after_releases(const RunData& run, const Window& window, double rest);

/// The only burst of a run that ends at its first clog: all passages.
/// \param kind first if the clog was reached, cut_off if the end of the run came before it
Burst burst_until_stop(const RunData& run, const Window& window, BurstKind kind);

}  // namespace clogflow::postprocess
