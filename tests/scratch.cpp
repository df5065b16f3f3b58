#include "tests/scratch.hpp"

#include <unistd.h>

#include <algorithm>

namespace clogflow {

ScratchFolder::ScratchFolder() {
  static int number = 0;
  path_ = std::filesystem::temp_directory_path() /
          ("clogflow_test_" + std::to_string(getpid()) + "_" + std::to_string(++number));
  std::filesystem::remove_all(path_);
  std::filesystem::create_directories(path_);
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::vector<std::string> files_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.push_back(entry.path().filename());
  std::ranges::sort(names);
  return names;
}

const std::filesystem::path& scratch_folder() {
  static const ScratchFolder folder;
  return folder.path();
}

}  // namespace clogflow
