#include "ensemble/seed_lock.hpp"

#include <fcntl.h>
#include <pwd.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <system_error>
#include <utility>

#include "coupling/base/require.hpp"

namespace clogflow {
namespace {

std::string last_reason() { return std::error_code(errno, std::generic_category()).message(); }

std::filesystem::path lock_file(std::filesystem::path run_file) { return run_file.replace_extension(".lock"); }

std::string line_in(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  return line;
}

bool is_file(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::exists(file, ignored);
}

/// The holder before may have removed the file between our open and our lock.
bool is_still_there(int descriptor, const std::filesystem::path& file) {
  struct stat ours {
  }, named{};
  return ::fstat(descriptor, &ours) == 0 && ::stat(file.c_str(), &named) == 0 && ours.st_ino == named.st_ino &&
         ours.st_dev == named.st_dev;
}

/// For persons and for the other ranks' messages; on a full disk it stays empty, and the lock holds.
void write_holder(int descriptor, const std::string& holder) {
  if (::ftruncate(descriptor, 0) != 0) return;
  [[maybe_unused]] const ssize_t written = ::pwrite(descriptor, holder.data(), holder.size(), 0);
}

std::string owner_of(const std::filesystem::path& file) {
  struct stat named {};
  if (::stat(file.c_str(), &named) != 0) return "somebody";
  const passwd* user = ::getpwuid(named.st_uid);
  return user ? fmt::format("user {}", user->pw_name) : fmt::format("user {}", named.st_uid);
}

[[noreturn]] void refuse_foreign(const std::filesystem::path& file) {
  std::string holder = line_in(file);
  holder = holder.substr(holder.find(' ') + 1);
  throw Error(
      fmt::format("{} (belongs to {}, whose lock cannot be tried{}): wait until it is gone, let its owner remove it, "
                  "or give another --out",
                  file.string(), owner_of(file), holder.empty() ? "" : "; it says: " + holder));
}

/// What another user made is opened for reading: that is enough to lock it.
int open_lock(const std::filesystem::path& file) {
  int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor >= 0) return descriptor;
  const int reason = errno;
  // Protected regular files of sticky folders refuse O_CREAT even to those who may write.
  if (reason == EACCES) descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor >= 0) return descriptor;
  if (reason == EACCES && errno == EACCES && is_file(file)) refuse_foreign(file);
  errno = reason;
  throw Error(fmt::format("{} (cannot be written: {}): give another --out", file.string(), last_reason()));
}

}  // namespace

std::optional<SeedLock> SeedLock::take(const std::filesystem::path& run_file, const std::string& holder) {
  const std::filesystem::path file = lock_file(run_file);
  while (true) {
    const int descriptor = open_lock(file);
    SeedLock lock(file, descriptor);
    if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
      lock.works_ = false;
      const bool held = errno == EWOULDBLOCK, unusable = errno == EBADF;
      // Not ours to remove.
      if (held || unusable) ::close(std::exchange(lock.descriptor_, -1));
      if (held) return {};
      // NFS locks only what may be written.
      if (unusable) refuse_foreign(file);
      return lock;
    }
    if (is_still_there(descriptor, file)) {
      write_holder(descriptor, holder);
      return lock;
    }
    ::close(std::exchange(lock.descriptor_, -1));
  }
}

std::string SeedLock::holder(const std::filesystem::path& run_file) { return line_in(lock_file(run_file)); }

bool SeedLock::is_there(const std::filesystem::path& run_file) { return is_file(lock_file(run_file)); }

SeedLock::SeedLock(SeedLock&& other) noexcept
    : file_(std::move(other.file_)), descriptor_(std::exchange(other.descriptor_, -1)), works_(other.works_) {}

SeedLock::~SeedLock() {
  if (descriptor_ < 0) return;
  ::unlink(file_.c_str());
  ::close(descriptor_);
}

}  // namespace clogflow
