#include "dem/seed_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <system_error>
#include <utility>

#include "coupling/require.hpp"

namespace clog {
namespace {

std::string last_reason() { return std::error_code(errno, std::generic_category()).message(); }

std::filesystem::path lock_file(std::filesystem::path run_file) { return run_file.replace_extension(".lock"); }

/// The holder before may have removed the file between our open and our lock.
bool is_still_there(int descriptor, const std::filesystem::path& file) {
  struct stat ours{}, named{};
  return ::fstat(descriptor, &ours) == 0 && ::stat(file.c_str(), &named) == 0 &&
         ours.st_ino == named.st_ino && ours.st_dev == named.st_dev;
}

/// For persons and for the other ranks' messages; on a full disk it stays empty, and the lock holds.
void write_holder(int descriptor, const std::string& holder) {
  if (::ftruncate(descriptor, 0) != 0) return;
  [[maybe_unused]] const ssize_t written = ::pwrite(descriptor, holder.data(), holder.size(), 0);
}

}  // namespace

std::optional<SeedLock> SeedLock::take(const std::filesystem::path& run_file, const std::string& holder) {
  const std::filesystem::path file = lock_file(run_file);
  while (true) {
    const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    require(descriptor >= 0, "{} (cannot be written: {}): give another --out", file.string(), last_reason());
    SeedLock lock(file, descriptor);
    if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
      lock.works_ = false;
      if (errno == EWOULDBLOCK) {
        // Not ours to remove.
        ::close(std::exchange(lock.descriptor_, -1));
        return {};
      }
      return lock;
    }
    if (is_still_there(descriptor, file)) {
      write_holder(descriptor, holder);
      return lock;
    }
    ::close(std::exchange(lock.descriptor_, -1));
  }
}

std::string SeedLock::holder(const std::filesystem::path& run_file) {
  std::ifstream file(lock_file(run_file));
  std::string line;
  std::getline(file, line);
  return line;
}

bool SeedLock::is_there(const std::filesystem::path& run_file) {
  std::error_code ignored;
  return std::filesystem::exists(lock_file(run_file), ignored);
}

SeedLock::SeedLock(SeedLock&& other) noexcept
    : file_(std::move(other.file_)), descriptor_(std::exchange(other.descriptor_, -1)), works_(other.works_) {}

SeedLock::~SeedLock() {
  if (descriptor_ < 0) return;
  ::unlink(file_.c_str());
  ::close(descriptor_);
}

}  // namespace clog
