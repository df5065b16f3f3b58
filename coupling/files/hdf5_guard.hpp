// What a file from elsewhere may make the HDF5 library do: read this one file, and no more of it
// than it holds.
#pragma once

#include <string>

#include "coupling/files/hdf5_file.hpp"

namespace clogflow {

/// Whether a group holds a link of that name. \return false where there is none
/// \throws Error("<path> (...)") for a link that is no plain one
bool has_plain_link(std::int64_t group, const std::string& name, const std::string& path);

/// What forbids reading a dataset, or an empty text: another file's bytes, filters that we do not
/// write, pieces out of proportion. Asked before its extent, for which the library opens the
/// sources of a virtual dataset.
std::string storage_fault(std::int64_t dataset);

/// What forbids reading `bytes` from a dataset, or an empty text: more than its stored bytes can
/// unpack to.
std::string size_fault(std::int64_t dataset, double bytes);

/// deflate shrinks at most 1032 times
constexpr double largest_ratio = 1040;

}  // namespace clogflow
