#include "cli/log_file.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <ctime>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include "coupling/base/require.hpp"
#include "ensemble/launch.hpp"

namespace clogflow::cli {
namespace {

/// "2026-11-27 08:12:01.123 +0100"
std::string time_now() {
  using namespace std::chrono;
  const auto now = system_clock::now();
  const std::time_t seconds = system_clock::to_time_t(now);
  std::tm local{};
  localtime_r(&seconds, &local);
  std::array<char, 32> day{}, zone{};
  std::strftime(day.data(), day.size(), "%Y-%m-%d %H:%M:%S", &local);
  std::strftime(zone.data(), zone.size(), "%z", &local);
  const auto part = duration_cast<milliseconds>(now.time_since_epoch()).count() % 1000;
  return fmt::format("{}.{:03} {}", day.data(), part, zone.data());
}

/// Whether the file begins as our lines do; adding to a run file, say, would spoil it.
bool begins_with_a_time(int descriptor) {
  constexpr const char* shape = "0000-00-00 00:00:00.000 ";
  std::array<char, 24> first{};
  if (::pread(descriptor, first.data(), first.size(), 0) != static_cast<ssize_t>(first.size())) return false;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const bool digit = first[i] >= '0' && first[i] <= '9';
    if (shape[i] == '0' ? !digit : first[i] != shape[i]) return false;
  }
  return true;
}

/// `clog run` refuses an environment that contradicts itself, with its own words; here it is as good as none.
bool is_rank_0() {
  try {
    return launch_from_environment().rank == 0;
  } catch (const Error&) {
    return true;
  }
}

}  // namespace

LogFile::~LogFile() {
  if (!rest_.empty()) add("\n");
  if (descriptor_ >= 0) ::close(descriptor_);
}

void LogFile::open(const std::filesystem::path& file, const std::string& call) {
  constexpr mode_t for_all = 0666;  // less the umask
  descriptor_ = ::open(file.c_str(), O_RDWR | O_APPEND | O_CREAT | O_CLOEXEC, for_all);
  require(descriptor_ >= 0, "--log {}: cannot be written ({})", file.string(), std::strerror(errno));
  struct stat state {};
  const bool is_old_file = ::fstat(descriptor_, &state) == 0 && S_ISREG(state.st_mode) && state.st_size > 0;
  if (is_old_file && !begins_with_a_time(descriptor_)) {
    ::close(std::exchange(descriptor_, -1));
    throw Error(fmt::format("--log {}: is there and no log of this program: give another name", file.string()));
  }
  if (is_rank_0()) add(call + "\n");
}

void LogFile::add(const std::string& text) {
  if (descriptor_ < 0) return;
  rest_ += text;
  const std::size_t end = rest_.rfind('\n');
  if (end == std::string::npos) return;
  std::string lines;
  const std::string now = time_now();
  for (std::size_t at = 0; at <= end;) {
    const std::size_t next = rest_.find('\n', at) + 1;
    lines += now + "  " + rest_.substr(at, next - at);
    at = next;
  }
  rest_.erase(0, end + 1);
  if (::write(descriptor_, lines.data(), lines.size()) != static_cast<ssize_t>(lines.size())) whole_ = false;
}

}  // namespace clogflow::cli
