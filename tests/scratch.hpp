// Files that a test writes: in a folder of its own process, since tests run beside each other.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>

namespace clog {

/// Made at the first call, gone when the process ends.
inline const std::filesystem::path& scratch_folder() {
  struct Folder {
    Folder()
        : path(std::filesystem::temp_directory_path() /
               ("clogflow_test_" + std::to_string(getpid()))) {
      std::filesystem::remove_all(path);
      std::filesystem::create_directories(path);
    }
    ~Folder() {
      std::error_code ignored;
      std::filesystem::remove_all(path, ignored);
    }
    std::filesystem::path path;
  };
  static const Folder folder;
  return folder.path;
}

}  // namespace clog
