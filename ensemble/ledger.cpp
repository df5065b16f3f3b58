#include "ensemble/ledger.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <map>
#include <system_error>
#include <vector>

#include "coupling/base/require.hpp"

namespace clogflow {

namespace {

constexpr char header[] = "call,rank,host,seed,began_unix_s,ended_unix_s,outcome,point\n";

/// An open file that closes, and is unlocked, at the end of the scope.
struct Descriptor {
  int number;
  ~Descriptor() { ::close(number); }
};

[[noreturn]] void refuse(const std::filesystem::path& file) {
  throw Error(fmt::format("{} (cannot be written: {})", file.string(),
                          std::error_code(errno, std::generic_category()).message()));
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  for (std::size_t at = 0; at <= line.size();) {
    const std::size_t end = std::min(line.find(',', at), line.size());
    cells.push_back(line.substr(at, end - at));
    at = end + 1;
  }
  return cells;
}

}  // namespace

Stopwatch::Stopwatch()
    : began_(std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count()) {}

double Stopwatch::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

std::string Ledger::name_of(const std::string& point, std::uint64_t seed) {
  return fmt::format("{}\"{}\"", seed, point);
}

void Ledger::append(const LedgerEntry& entry) const {
  const int number = ::open(file_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (number < 0) refuse(file_);
  const Descriptor descriptor{number};
  // Where there are no locks, appending at once is as whole as the system makes it.
  while (::flock(number, LOCK_EX) != 0 && errno == EINTR) {
  }
  struct stat before {};
  if (::fstat(number, &before) != 0) refuse(file_);
  // A process that was killed in the middle leaves a line without its end.
  char last = '\n';
  if (before.st_size > 0 && ::pread(number, &last, 1, before.st_size - 1) != 1) refuse(file_);
  const char* begin = before.st_size == 0 ? header : last == '\n' ? "" : "\n";
  const std::string line = fmt::format("{}{},{},{},{},{:.3f},{:.3f},{},\"{}\"\n", begin, launch_.call, launch_.rank,
                                       launch_.host, entry.seed, entry.began, entry.ended, entry.outcome, entry.point);
  const ssize_t written = ::write(number, line.data(), line.size());
  if (written == static_cast<ssize_t>(line.size())) return;
  const int reason = written < 0 ? errno : ENOSPC;
  [[maybe_unused]] const int cut = ::ftruncate(number, before.st_size);
  errno = reason;
  refuse(file_);
}

Ledger::Sum Ledger::sum(const std::set<std::string>& asked_for) const {
  std::ifstream file(file_);
  Sum sum;
  std::map<std::string, std::string> last_ends;
  for (std::string line; std::getline(file, line);) {
    const auto cells = cells_of(line);
    if (cells.size() < 8 || cells[0] != launch_.call) continue;
    sum.busy += std::strtod(cells[5].c_str(), nullptr) - std::strtod(cells[4].c_str(), nullptr);
    // The name of a point may hold commas of its own: it is the rest of the line.
    const std::string name = cells[3] + line.substr(std::min(line.find('"'), line.size()));
    if (asked_for.contains(name)) last_ends[name] = cells[6];
  }
  for (const auto& [name, end] : last_ends) sum.failed += end == "failed";
  return sum;
}

}  // namespace clogflow
