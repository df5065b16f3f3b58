// The program as a child process: started, killed, waited for; what it said is kept.
#pragma once

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <thread>

#include "tests/faults/small_channel.hpp"

namespace clogflow::test {

inline std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Kills of a test: so many, times what `./Alltest --nightly kills` asks for.
inline int kills(int usual) {
  const char* factor = std::getenv("CLOG_TEST_KILLS");
  return usual * (factor ? std::max(1, std::atoi(factor)) : 1);
}

/// One call of `clog`, its output in a log file.
class Program {
public:
  Program(const std::vector<std::string>& arguments, std::filesystem::path log) : log_(std::move(log)) {
    std::vector<char*> words{const_cast<char*>(CLOG_PROGRAM)};
    for (const auto& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    child_ = fork();
    if (child_ != 0) return;
    const int out = ::open(log_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    dup2(out, 1), dup2(out, 2);
    execv(CLOG_PROGRAM, words.data());
    _exit(127);
  }

  void send(int signal) const { ::kill(child_, signal); }

  /// Exit status; minus the signal's number if one ended it.
  int wait() const {
    int status = 0;
    waitpid(child_, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

  std::string said() const { return text_of(log_); }

private:
  std::filesystem::path log_;
  pid_t child_ = -1;
};

inline void sleep_ms(int milliseconds) { std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds)); }

/// A scene and its flow in a folder, and calls of `clog run` on them.
class SmallJob {
public:
  explicit SmallJob(const Overrides& more = {}) {
    Overrides overrides = {"output.checkpoint_interval=20 ms"};
    overrides.insert(overrides.end(), more.begin(), more.end());
    scene = small_channel(overrides);
    flow = synthetic_flow(scene);
    write_flow_grid(flow, path("flow.h5"));
    write_file(path("scene.toml"), effective_scene(scene));
  }

  std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }

  Program start(const std::string& out, const std::string& seeds, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"run",   path("scene.toml"), "--flow",  path("flow.h5"),
                                   "--out", path(out),          "--seeds", seeds};
    words.insert(words.end(), more.begin(), more.end());
    return {words, path("log")};
  }

  /// Runs to the end; the output if that failed.
  std::string complete(const std::string& out, const std::string& seeds,
                       const std::vector<std::string>& more = {}) const {
    const Program program = start(out, seeds, more);
    const int status = program.wait();
    return status == 0 ? "" : fmt::format("status {}: {}", status, program.said());
  }

  std::string result(const std::string& out, std::uint64_t seed) const {
    return result_bytes(path(out) / run_file_name(seed));
  }

  Scene scene;
  FlowGrid flow;

private:
  ScratchFolder folder_;
};

/// A run long enough to be met in the middle.
inline const Overrides longer = {"time.end=120 ms"};

/// Waits until a file is there, ten seconds at most.
inline bool appears(const std::filesystem::path& file) {
  for (int k = 0; k < 2000 && !std::filesystem::exists(file); ++k) sleep_ms(5);
  return std::filesystem::exists(file);
}

}  // namespace clogflow::test
