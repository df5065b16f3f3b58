// The unfinished form of a file, beside its final name, in the hands of one process alone.
#pragma once

#include <filesystem>

namespace clogflow {

/// When a file gets its name. `written`: at once, for content that proves itself by a checksum and has another
/// file to fall back on should the power fail; who is about to be killed has no time to wait for the disk.
enum class NamedWhen { flushed, written };

/// "<file>.clog.part", or "<file>.clog2.part" and so on while another process writes the one
/// before. It is made anew, never opened through a link, and locked as long as any process has it
/// open: what a killed process left is known by its free lock and taken away. Where the file system
/// has no locks such a remainder stays. The destructor removes the part unless it was published.
class FilePart {
public:
  /// \throws Error when the file is there and no regular file (a device, a folder), or the part
  /// cannot be made; with the file and the system's reason
  explicit FilePart(const std::filesystem::path& file);
  ~FilePart();
  FilePart(const FilePart&) = delete;
  FilePart& operator=(const FilePart&) = delete;

  const std::filesystem::path& path() const { return part_; }
  int descriptor() const { return descriptor_; }

  /// Flushes it to the disk and gives it its name. \throws Error as above
  void publish(NamedWhen named = NamedWhen::flushed);

private:
  bool take(const std::filesystem::path& part);

  std::filesystem::path file_, part_;
  int descriptor_ = -1;
};

/// Removes the parts of a file that killed processes left.
void clear_remainders(const std::filesystem::path& file);

}  // namespace clogflow
