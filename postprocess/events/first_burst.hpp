// The first burst of a run, which nothing but the start came before: one a seed, independent of all others.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>

#include "coupling/files/run_file.hpp"
#include "coupling/scene/scene.hpp"
#include "postprocess/events/lapses.hpp"
#include "postprocess/laws/trial_count.hpp"

namespace clogflow::postprocess {

struct FirstBurst {
  std::size_t size = 0;                 ///< passages with friction on before the first clog; 0 is possible
  bool clogged = false;                 ///< otherwise the end of the run cut it: the size is a lower bound
  std::optional<double> clog_position;  ///< x of the most downstream particle of that clog, if the run says [m]
  double packing_flowing = std::numeric_limits<double>::quiet_NaN();  ///< near the neck, until its last passage [-]
  double packing_at_end = std::numeric_limits<double>::quiet_NaN();   ///< there, in the last sample before its end [-]
};

/// What the first clog is depends on unclog.protocol:
///   stop                    the one that ended the run, by its record (`clogged_at`)
///   release, restart, poke  the one that the first of the `releases` ended
///   none                    the one in which the run ends, if it lasts (ends_clogged). Arrests before it that a
///   passage
///                           ended are none, however long: nothing tells whether they were at rest, and `stop`, whose
///                           clogs are at rest for good, would not have ended the run there
/// Near the neck is the last of the porosity.strips. \param window passages outside do not count \param tau [s]
FirstBurst first_burst_of(const RunData& run, const Scene& scene, const Window& window, double tau);

/// A particle passes, or the neck clogs before it can.
inline TrialCount as_trials(const FirstBurst& burst) { return {burst.size, burst.clogged}; }

}  // namespace clogflow::postprocess
