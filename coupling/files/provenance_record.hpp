// The record of how a flow or run file came about: JSON, of which some entries are used in
// computations.
#pragma once

#include <nlohmann/json.hpp>

#include "coupling/files/hdf5_file.hpp"

namespace clogflow {

/// The text "/provenance/record" of a file. \throws Error naming the file unless it is an object
/// (or null), and what is used as a number or a text is one
nlohmann::json read_record(const Hdf5Reader& file);

}  // namespace clogflow
