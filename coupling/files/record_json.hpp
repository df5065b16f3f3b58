// Records as JSON: the one place where their entries have names instead of members.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "coupling/files/flow_record.hpp"
#include "coupling/files/hdf5_file.hpp"
#include "coupling/files/run_record.hpp"

namespace clogflow {

/// The entries that are there, those of other programs included; null if none is.
nlohmann::json record_json(const RunRecord& record);
nlohmann::json record_json(const FlowRecord& record);

void write_record(Hdf5Writer& file, const RunRecord& record);
void write_record(Hdf5Writer& file, const FlowRecord& record);

/// Record: RunRecord or FlowRecord.
/// \throws Error naming the file unless the text is a JSON object (or null) and its entries are what they should be
template <class Record>
Record read_record(const Hdf5Reader& file);

}  // namespace clogflow
