// Gives a file its name only when it is whole and on the disk.
#pragma once

#include <filesystem>
#include <string>

namespace clog {

/// Writes "<file>.part" beside, flushes it to the disk, renames it. On failure an older file of
/// that name is untouched and nothing else remains. \throws Error naming the file and the system's
/// reason
void publish_file(const std::string& content, const std::filesystem::path& file);

/// The second half alone, for a complete `part` written by other means.
void rename_whole_file(const std::filesystem::path& part, const std::filesystem::path& file);

}  // namespace clog
