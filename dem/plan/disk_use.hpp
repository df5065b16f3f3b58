// What a run leaves on disk.
#pragma once

#include <cstddef>

#include "coupling/scene/scene.hpp"
#include "dem/plan/burst_cost.hpp"

namespace clogflow {

/// Bytes of one run file and the index beside it. Each part is rows times bytes a row, as the parts were seen in files:
/// large tables are compressed there. The flow, the statistics and the report are not counted.
struct DiskUse {
  double snapshots = 0;       ///< [bytes]
  double series = 0;          ///< [bytes]
  double passages = 0;        ///< [bytes]
  double end_state = 0;       ///< from which the run could be lengthened [bytes]
  double rest = 0;            ///< scene, provenance, names of tables [bytes]
  bool is_at_most = false;    ///< how often the neck clogs is not known: as if it never did
  double snapshot_count = 0;  ///< [-]
  double series_rows = 0;     ///< [-]
  double passage_count = 0;   ///< [-]

  double run() const { return snapshots + series + passages + end_state + rest; }

  /// While a seed runs its state is saved beside, with all that was recorded, before the old one goes. [bytes]
  double at_work() const { return 2 * (snapshots + series + passages + end_state); }
};

/// Of a run with so many particles; `burst` is what is known of its bursts.
DiskUse disk_use(const Scene& scene, double particles, const ExpectedBurst& burst);

}  // namespace clogflow
