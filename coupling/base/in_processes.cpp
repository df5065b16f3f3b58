#include "coupling/base/in_processes.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <memory>
#include <system_error>
#include <thread>
#include <vector>

#include "coupling/base/require.hpp"

namespace clogflow {
namespace {

std::string system_words() { return std::error_code(errno, std::generic_category()).message(); }

bool write_all(int to, const void* bytes, std::size_t size) {
  const char* at = static_cast<const char*>(bytes);
  while (size > 0) {
    const ssize_t written = ::write(to, at, size);
    if (written < 0 && errno != EINTR) return false;
    if (written > 0) at += written, size -= static_cast<std::size_t>(written);
  }
  return true;
}

bool read_all(int from, void* bytes, std::size_t size) {
  char* at = static_cast<char*>(bytes);
  while (size > 0) {
    const ssize_t got = ::read(from, at, size);
    if (got == 0 || (got < 0 && errno != EINTR)) return false;
    if (got > 0) at += got, size -= static_cast<std::size_t>(got);
  }
  return true;
}

/// One process, and the pipe through which its results come. A pipe holds 64 kB: so far a worker runs ahead.
class Worker {
public:
  explicit Worker(const std::function<void(int)>& write_results) {
    int ends[2];
    require(::pipe(ends) == 0, "no pipe to a further process ({})", system_words());
    pid_ = ::fork();
    if (pid_ == 0) {
      ::close(ends[0]);
      // Whoever asked may end before us: the write then fails, and there is nothing more to do.
      std::signal(SIGPIPE, SIG_IGN);
      int status = 1;
      try {
        write_results(ends[1]);
        status = 0;
      } catch (...) {
      }
      // Without the clean-up of the process that this one is a copy of.
      ::_exit(status);
    }
    ::close(ends[1]);
    from_ = ends[0];
    if (pid_ < 0) {
      ::close(from_);
      throw Error(fmt::format("no further process can be begun ({})", system_words()));
    }
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  ~Worker() { end(); }

  /// In a process forked later: it must not keep this pipe open, or its worker never learns that nobody reads.
  void forget() const { ::close(from_); }

  std::string next() {
    std::size_t size = 0;
    std::string bytes;
    bool whole = read_all(from_, &size, sizeof size);
    if (whole) {
      bytes.resize(size);
      whole = read_all(from_, bytes.data(), size);
    }
    if (!whole) {
      const int status = end();
      throw Error(WIFSIGNALED(status)
                      ? fmt::format("a process at work on a part was ended by signal {} (killed, or out "
                                    "of memory)",
                                    WTERMSIG(status))
                      : "a process at work on a part ended early (out of memory?)");
    }
    return bytes;
  }

private:
  int end() {
    if (pid_ <= 0) return 0;
    ::close(from_);
    int status = 0;
    while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    pid_ = -1;
    return status;
  }

  pid_t pid_ = -1;
  int from_ = -1;
};

}  // namespace

std::size_t usable_cores() { return std::max(1U, std::thread::hardware_concurrency()); }

void in_processes(std::size_t count, std::size_t workers, const std::function<std::string(std::size_t)>& work,
                  const std::function<void(std::size_t, std::string)>& take) {
  workers = std::min(workers, count);
  if (workers <= 1) {
    for (std::size_t i = 0; i < count; ++i) take(i, work(i));
    return;
  }
  std::vector<std::unique_ptr<Worker>> all;
  for (std::size_t w = 0; w < workers; ++w)
    all.push_back(std::make_unique<Worker>([&](int to) {
      for (const auto& earlier : all) earlier->forget();
      for (std::size_t i = w; i < count; i += workers) {
        const std::string bytes = work(i);
        const std::size_t size = bytes.size();
        if (!write_all(to, &size, sizeof size) || !write_all(to, bytes.data(), size)) return;
      }
    }));
  for (std::size_t i = 0; i < count; ++i) take(i, all[i % workers]->next());
}

}  // namespace clogflow
