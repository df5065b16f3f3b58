#include "coupling/base/file_part.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "coupling/base/require.hpp"

namespace clogflow {
namespace {

namespace fs = std::filesystem;

/// So many writers of one file at once, or remainders without locks, are a mistake.
constexpr int most_parts = 1000;

std::error_code last_error() { return {errno, std::generic_category()}; }

[[noreturn]] void refuse(const fs::path& file, const std::error_code& reason) {
  throw Error(fmt::format("{} (cannot be written: {})", file.string(), reason.message()));
}

enum class Lock { held, busy, unknown };

// Locks of the open file, not of flock's kind: HDF5 takes those by itself, which would exclude us.
Lock lock(int descriptor) {
  struct flock whole {};
  whole.l_type = F_WRLCK;
  whole.l_whence = SEEK_SET;
  if (::fcntl(descriptor, F_OFD_SETLK, &whole) == 0) return Lock::held;
  return errno == EAGAIN || errno == EACCES ? Lock::busy : Lock::unknown;
}

bool is_still(int descriptor, const fs::path& path) {
  struct stat opened {
  }, named{};
  return ::fstat(descriptor, &opened) == 0 && ::lstat(path.c_str(), &named) == 0 && S_ISREG(named.st_mode) &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

/// Removes what a process left that no longer lives: only its lock, which ended with it, tells.
void clear_remainder(const fs::path& part) {
  const int descriptor = ::open(part.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return;
  if (is_still(descriptor, part) && lock(descriptor) == Lock::held && is_still(descriptor, part))
    ::unlink(part.c_str());
  ::close(descriptor);
}

fs::path part_name(const fs::path& file, int number) {
  return number == 1 ? file.string() + ".clog.part" : fmt::format("{}.clog{}.part", file.string(), number);
}

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : "."; }

// Some file systems refuse this for folders; the file itself is whole anyway.
void flush_folder(const fs::path& file) {
  const int descriptor = ::open(folder_of(file).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

// A rename would put our file in the place of a device such as /dev/null; root may do that.
void require_replaceable(const fs::path& file) {
  std::error_code ignored;
  const auto there = fs::status(file, ignored);
  if (!fs::exists(there) || fs::is_regular_file(there)) return;
  refuse(file, std::make_error_code(fs::is_directory(there) ? std::errc::is_a_directory : std::errc::invalid_argument));
}

}  // namespace

FilePart::FilePart(const fs::path& file) : file_(file) {
  require_replaceable(file);
  for (int i = 1; i <= most_parts; ++i) {
    const fs::path part = part_name(file, i);
    if (take(part)) return;
    if (errno != EEXIST) refuse(file, last_error());
    clear_remainder(part);
    if (take(part)) return;
    if (errno != EEXIST) refuse(file, last_error());
  }
  throw Error(
      fmt::format("{} (cannot be written: {} unfinished ones lie beside it); remove {}.clog*.part "
                  "if no process writes them",
                  file.string(), most_parts, file.string()));
}

/// \return false, with errno, if it is not ours
bool FilePart::take(const fs::path& part) {
  const int descriptor = ::open(part.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (descriptor < 0) return false;
  // Between the two, another process may have taken it for a remainder.
  if (lock(descriptor) == Lock::busy || !is_still(descriptor, part)) {
    ::close(descriptor);
    errno = EEXIST;
    return false;
  }
  part_ = part;
  descriptor_ = descriptor;
  return true;
}

FilePart::~FilePart() {
  if (descriptor_ < 0) return;
  if (is_still(descriptor_, part_)) ::unlink(part_.c_str());
  ::close(descriptor_);
}

void FilePart::publish(NamedWhen named) {
  if (named == NamedWhen::flushed && ::fsync(descriptor_) != 0) refuse(file_, last_error());
  require_replaceable(file_);
  if (::rename(part_.c_str(), file_.c_str()) != 0) refuse(file_, last_error());
  if (named == NamedWhen::written && ::fsync(descriptor_) != 0) refuse(file_, last_error());
  // The lock goes with it: nobody takes for a remainder what has its name.
  ::close(descriptor_);
  descriptor_ = -1;
  flush_folder(file_);
}

void clear_remainders(const fs::path& file) {
  std::error_code ignored;
  const std::string begin = file.filename().string() + ".clog";
  for (fs::directory_iterator at(folder_of(file), ignored), end; !ignored && at != end; at.increment(ignored)) {
    const std::string name = at->path().filename();
    if (name.starts_with(begin) && name.ends_with(".part")) clear_remainder(at->path());
  }
}

}  // namespace clogflow
