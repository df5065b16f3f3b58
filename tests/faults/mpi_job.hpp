// `mpirun clog run` as a child, and its ranks, to be killed one by one.
#pragma once

#include <fstream>
#include <random>

#include "tests/faults/program.hpp"

namespace clogflow::test {

/// Processes whose parent this is and that run the program.
inline std::vector<pid_t> ranks_below(pid_t parent) {
  std::vector<pid_t> ranks;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const std::string name = entry.path().filename().string();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    // "pid (name) state parent ..."
    std::istringstream stat(text_of(entry.path() / "stat"));
    std::string id, program, state;
    pid_t of = 0;
    if (stat >> id >> program >> state >> of && of == parent && program == "(clog)" && state != "Z")
      ranks.push_back(std::stoi(id));
  }
  return ranks;
}

/// A call of the program under mpirun.
class MpiJob {
public:
  MpiJob(const std::vector<std::string>& options, const std::vector<std::string>& words, std::filesystem::path log)
      : log_(std::move(log)) {
    std::vector<std::string> all{"mpirun", "--oversubscribe", "--bind-to", "none"};
    if (geteuid() == 0) all.push_back("--allow-run-as-root");
    all.insert(all.end(), options.begin(), options.end());
    all.push_back(CLOG_PROGRAM);
    all.insert(all.end(), words.begin(), words.end());
    std::vector<char*> arguments;
    for (std::string& word : all) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    child_ = fork();
    if (child_ != 0) return;
    // Open MPI leaves memory behind at its end: where the sanitizers watch, leaks are looked for without it.
    ::setenv("ASAN_OPTIONS", "detect_leaks=0", 1);
    const int out = ::open(log_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    dup2(out, 1), dup2(out, 2);
    execvp("mpirun", arguments.data());
    _exit(127);
  }

  std::vector<pid_t> ranks() const { return ranks_below(child_); }

  bool ended() {
    if (!ended_ && waitpid(child_, &status_, WNOHANG) == child_) ended_ = true;
    return ended_;
  }

  int wait() {
    if (!ended_) waitpid(child_, &status_, 0);
    ended_ = true;
    return WIFEXITED(status_) ? WEXITSTATUS(status_) : -WTERMSIG(status_);
  }

  void send(int signal) const { ::kill(child_, signal); }
  std::string said() const { return text_of(log_); }

private:
  std::filesystem::path log_;
  pid_t child_ = -1;
  int status_ = 0;
  bool ended_ = false;
};

}  // namespace clogflow::test
