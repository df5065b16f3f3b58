#include "coupling/files/provenance_record.hpp"

#include <fmt/format.h>

#include "coupling/base/json_text.hpp"
#include "coupling/files/run_record.hpp"

namespace clogflow {

nlohmann::json read_record(const Hdf5Reader& file) {
  constexpr const char* place = "/provenance/record";
  nlohmann::json record = parse_json(file.read_text(place));
  file.check(!record.is_discarded(), fmt::format("{} is no JSON, or nested too deep", place));
  file.check(record.is_object() || record.is_null(), fmt::format("{} is no JSON object", place));
  for (const char* name : {run_record::wall_time, run_record::particle_steps, run_record::particle_steps_per_s,
                           run_record::time_step, run_record::contact_limit, run_record::fill_time})
    file.check(!record.contains(name) || record[name].is_number(), fmt::format("{}: {} is no number", place, name));
  for (const char* name : {run_record::inputs_hash, "flow_hash"})
    file.check(!record.contains(name) || record[name].is_string(), fmt::format("{}: {} is no text", place, name));
  return record;
}

}  // namespace clogflow
