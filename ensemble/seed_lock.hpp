// One process at a time works on a seed: calls on the same directory share its seeds and cannot spoil them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace clogflow {

/// Holds "run_0007.lock" beside the run file for as long as it lives. The lock is the kernel's (flock, which
/// NFS carries from node to node), so it ends with its process however that ends, and a file left behind locks
/// nothing. The file says who holds it.
class SeedLock {
public:
  /// Nothing if another process holds it. \param holder  what the file says of us, one line
  /// \throws Error if the file cannot be made, or is another user's and cannot be opened
  static std::optional<SeedLock> take(const std::filesystem::path& run_file, const std::string& holder);

  /// What the holder wrote; empty if there is none.
  static std::string holder(const std::filesystem::path& run_file);

  /// Whether somebody holds the lock, or died with it.
  static bool is_there(const std::filesystem::path& run_file);

  /// False on a file system without locks: then nothing is held.
  bool works() const { return works_; }

  SeedLock(SeedLock&& other) noexcept;
  SeedLock& operator=(SeedLock&&) = delete;
  ~SeedLock();

private:
  SeedLock(std::filesystem::path file, int descriptor) : file_(std::move(file)), descriptor_(descriptor) {}

  std::filesystem::path file_;
  int descriptor_ = -1;
  bool works_ = true;
};

}  // namespace clogflow
