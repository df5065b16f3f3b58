#include "dem/seed_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "coupling/require.hpp"

namespace clog {
namespace {

std::string last_reason() { return std::error_code(errno, std::generic_category()).message(); }

/// The holder before may have removed the file between our open and our lock.
bool is_still_there(int descriptor, const std::filesystem::path& file) {
  struct stat ours{}, named{};
  return ::fstat(descriptor, &ours) == 0 && ::stat(file.c_str(), &named) == 0 &&
         ours.st_ino == named.st_ino && ours.st_dev == named.st_dev;
}

}  // namespace

SeedLock::SeedLock(const std::filesystem::path& run_file) : file_(run_file) {
  file_.replace_extension(".lock");
  while (true) {
    descriptor_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    require(descriptor_ >= 0, "{} (cannot be written: {}): give another --out", file_.string(),
            last_reason());
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
      if (errno != EWOULDBLOCK) return;
      ::close(descriptor_);
      throw Error(fmt::format("{} (another call is at work on this seed): wait for it, or give "
                              "another --out", file_.string()));
    }
    if (is_still_there(descriptor_, file_)) return;
    ::close(descriptor_);
  }
}

SeedLock::~SeedLock() {
  ::unlink(file_.c_str());
  ::close(descriptor_);
}

}  // namespace clog
