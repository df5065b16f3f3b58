// XDMF beside a run file: tells ParaView where each snapshot lies in the HDF5 arrays.
#pragma once

#include <filesystem>

#include "coupling/files/run_file.hpp"

namespace clogflow {

/// Writes "run_0001.xmf" beside "run_0001.h5"; none, and no stale one, when there are no snapshots.
/// \throws Error naming the file
void write_snapshot_index(const RunData& run, const std::filesystem::path& run_file);

}  // namespace clogflow
