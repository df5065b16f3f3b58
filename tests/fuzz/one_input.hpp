// What all fuzz targets share: an input is refused with one clear line, or taken; never anything else.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <fmt/format.h>
#include <unistd.h>

#include "coupling/base/require.hpp"

namespace clogflow::fuzz {

inline std::string as_text(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// The input as a file in memory if there is such a place; written anew for each input.
inline std::filesystem::path as_file(const std::uint8_t* data, std::size_t size) {
  static const std::filesystem::path file =
      (std::filesystem::is_directory("/dev/shm") ? std::filesystem::path("/dev/shm")
                                                 : std::filesystem::temp_directory_path()) /
      fmt::format("clogflow_fuzz_{}", getpid());
  static const int at_exit = std::atexit([] { std::filesystem::remove(file); });
  static_cast<void>(at_exit);
  std::ofstream(file, std::ios::binary | std::ios::trunc)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  return file;
}

/// A second line in a message or another kind of exception is a finding.
template <class Read>
int try_input(const Read& read) {
  try {
    read();
  } catch (const Error& error) {
    const std::string message = error.what();
    if (message.empty() || message.find('\n') != std::string::npos) {
      std::fprintf(stderr, "not one line: %s\n", message.c_str());
      std::abort();
    }
  }
  return 0;
}

/// For laws that a taken input must keep.
inline void must(bool condition, const char* law) {
  if (condition) return;
  std::fprintf(stderr, "broken: %s\n", law);
  std::abort();
}

}  // namespace clogflow::fuzz
