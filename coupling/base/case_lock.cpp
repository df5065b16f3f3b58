#include "coupling/base/case_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <string>
#include <system_error>
#include <thread>

#include "coupling/base/require.hpp"
#include "coupling/base/text_file.hpp"

namespace clogflow {

CaseLock::CaseLock(const std::filesystem::path& folder)
    : file_(folder / "lock"), descriptor_(::open(file_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666)) {
  require(descriptor_ >= 0, "{} (cannot be written: {})", file_.string(),
          std::error_code(errno, std::generic_category()).message());
}

CaseLock::~CaseLock() { ::close(descriptor_); }

bool CaseLock::take() { return ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK; }

bool CaseLock::take_patiently() {
  using namespace std::chrono_literals;
  // A case is written in a second; a solver keeps it for longer.
  const auto end = std::chrono::steady_clock::now() + 5s;
  while (!take()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(50ms);
  }
  return true;
}

std::string CaseLock::holder() const {
  const std::string text = read_text_file(file_);
  const std::string line = text.substr(0, text.find('\n'));
  return line.starts_with("process ") ? line : "another process";
}

}  // namespace clogflow
