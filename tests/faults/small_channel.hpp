// A channel of some ten particles with a made-up flow: a whole run, filling included, in under a second.
#pragma once

#include "coupling/base/archive.hpp"
#include "tests/coupling/flow_scene.hpp"
#include "tests/dem/channel_scene.hpp"

namespace clogflow::test {

/// Clogs and releases follow each other quickly, so that a short run meets every branch.
inline Scene small_channel(Overrides more = {}) {
  Overrides overrides = {"particles.diameter=50 um", "time.end=20 ms",         "inlet.taps=1",
                         "unclog.after=3 ms",        "unclog.duration=1.5 ms", "output.snapshot_interval=5 ms"};
  overrides.insert(overrides.end(), more.begin(), more.end());
  return short_channel_scene(overrides);
}

/// All that a run recorded, bit by bit, what a saved state keeps apart too; its record (wall time, host) is no result.
inline std::string result_bytes(RunData run) {
  run.record = {};
  ArchiveWriter archive;
  archive(run, run.series.flow_factor, run.series.pressure_drop);
  return archive.bytes();
}

inline std::string result_bytes(const std::filesystem::path& run_file) { return result_bytes(read_run_file(run_file)); }

}  // namespace clogflow::test
