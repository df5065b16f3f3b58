// Text files that appear under their final name only when they are whole.
#pragma once

#include <filesystem>
#include <string>

namespace clog::postprocess {

/// \throws Error naming the file
void write_text_file(const std::string& text, const std::filesystem::path& file);

}  // namespace clog::postprocess
