// One process at a time works on a seed: two calls on the same directory cannot spoil each other.
#pragma once

#include <filesystem>

namespace clog {

/// Holds "run_0007.lock" beside the run file for as long as it lives. The lock is the kernel's (flock), so
/// it ends with its process however that ends, and a file left behind locks nothing. On file systems
/// without locks nothing is held.
class SeedLock {
public:
  /// \throws Error if another process holds it, or if the file cannot be made
  explicit SeedLock(const std::filesystem::path& run_file);
  ~SeedLock();
  SeedLock(const SeedLock&) = delete;
  SeedLock& operator=(const SeedLock&) = delete;

private:
  std::filesystem::path file_;
  int descriptor_ = -1;
};

}  // namespace clog
