// Files that a test writes: in folders of its own process, since tests run beside each other.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace clogflow {

/// A folder of its own that goes away with its owner.
class ScratchFolder {
public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

private:
  std::filesystem::path path_;
};

/// Names of all that a folder holds, sorted.
std::vector<std::string> files_in(const std::filesystem::path& folder);

/// One for all tests of a process, gone when it ends.
const std::filesystem::path& scratch_folder();

}  // namespace clogflow
