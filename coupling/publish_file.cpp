// Write, flush, rename, flush the folder: the order that survives a power cut.
#include "coupling/publish_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "coupling/require.hpp"

namespace clog {
namespace {

std::error_code last_error() { return {errno, std::generic_category()}; }

std::error_code write_file(const std::filesystem::path& file, const std::string& content) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) return last_error();
  std::error_code failure;
  for (std::size_t done = 0; done < content.size() && !failure;) {
    const ssize_t written = ::write(descriptor, content.data() + done, content.size() - done);
    if (written >= 0) done += static_cast<std::size_t>(written);
    if (written < 0 && errno != EINTR) failure = last_error();
  }
  const bool closed = ::close(descriptor) == 0;
  return failure || closed ? failure : last_error();
}

std::error_code flush_path(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return last_error();
  const std::error_code failure = ::fsync(descriptor) == 0 ? std::error_code{} : last_error();
  ::close(descriptor);
  return failure;
}

void give_up(const std::filesystem::path& part, const std::filesystem::path& file,
             const std::error_code& reason) {
  std::error_code ignored;
  std::filesystem::remove(part, ignored);
  throw Error(fmt::format("{} (cannot be written: {})", file.string(), reason.message()));
}

}  // namespace

void publish_file(const std::string& content, const std::filesystem::path& file) {
  const std::filesystem::path part = file.string() + ".part";
  if (const std::error_code failure = write_file(part, content)) give_up(part, file, failure);
  rename_whole_file(part, file);
}

void rename_whole_file(const std::filesystem::path& part, const std::filesystem::path& file) {
  std::error_code failure = flush_path(part), ignored;
  // A rename would put our file in the place of a device such as /dev/null; root may do that.
  if (const auto there = std::filesystem::status(file, ignored);
      std::filesystem::exists(there) && !std::filesystem::is_regular_file(there))
    failure = std::make_error_code(std::filesystem::is_directory(there) ? std::errc::is_a_directory
                                                                         : std::errc::invalid_argument);
  if (!failure) std::filesystem::rename(part, file, failure);
  if (failure) give_up(part, file, failure);
  // Some file systems refuse this for folders; the file itself is whole anyway.
  flush_path(file.has_parent_path() ? file.parent_path() : ".");
}

}  // namespace clog
