// A plain text column of numbers: the input of `clog fit`.
#pragma once

#include <filesystem>
#include <vector>

namespace clogflow::postprocess {

/// One number a line; blank lines and everything after '#' are skipped.
/// \throws Error "file:line: ..." on anything else, or when the file cannot be read
std::vector<double> read_number_column(const std::filesystem::path& file);

}  // namespace clogflow::postprocess
