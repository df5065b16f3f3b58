// Snapshots, and the contacts in them, as tables of a run file.
#pragma once

#include <string>
#include <vector>

#include "coupling/files/hdf5_file.hpp"
#include "coupling/files/run_file.hpp"

namespace clogflow {

/// All snapshots one after another in one array a quantity; `first` is where each begins.
void write_snapshots(Hdf5Writer& out, const std::vector<RunData::Snapshot>& snapshots);

/// Likewise; written even where nothing touches, so that a reader knows that contacts were looked at.
void write_contacts(Hdf5Writer& out, const std::vector<RunData::Snapshot>& snapshots);

std::vector<RunData::Snapshot> read_snapshots(const Hdf5Reader& in);
void read_contacts(const Hdf5Reader& in, std::vector<RunData::Snapshot>& snapshots);

/// What is wrong with the lengths of their columns or the particles that contacts name; empty if nothing is.
std::string fault_in_snapshots(const std::vector<RunData::Snapshot>& snapshots);

}  // namespace clogflow
