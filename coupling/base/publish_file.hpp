// Gives a file its name only when it is whole and on the disk.
#pragma once

#include <filesystem>
#include <string>

#include "coupling/base/file_part.hpp"

namespace clogflow {

/// Writes it beside (FilePart), flushes it to the disk, renames it. On failure an older file of
/// that name is untouched and nothing else remains. \throws Error naming the file and the system's
/// reason
void publish_file(const std::string& content, const std::filesystem::path& file, NamedWhen named = NamedWhen::flushed);

}  // namespace clogflow
