// A whole text file at once.
#pragma once

#include <filesystem>
#include <string>

namespace clogflow {

/// \throws Error when the file is missing or cannot be read
std::string read_text_file(const std::filesystem::path& file);

}  // namespace clogflow
