// Words to the user that must not end the work they are about.
#pragma once

#include <cstdio>
#include <string>

namespace clogflow::cli {

/// Written at once. What cannot be written, to a log on a full disk for example, is lost, and main() says so at the
/// end where it was standard output; fmt::print would throw in the middle of a run.
inline void put(std::FILE* stream, const std::string& text) {
  std::fputs(text.c_str(), stream);
  std::fflush(stream);
}

}  // namespace clogflow::cli
