// Solves flow cases of tests with OpenFOAM.
#pragma once

#include <cstdio>
#include <filesystem>
#include <string>

#include <sys/wait.h>

namespace clogflow {

struct ShellResult {
  int status;
  std::string output;  ///< standard output and standard error
};

/// Runs a shell command to its end.
inline ShellResult shell(const std::string& command) {
  ShellResult result{-1, ""};
  FILE* pipe = popen(("( " + command + " ) 2>&1").c_str(), "r");
  if (!pipe) return result;
  char buffer[4096];
  while (const auto n = std::fread(buffer, 1, sizeof buffer, pipe)) result.output.append(buffer, n);
  const int status = pclose(pipe);
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return result;
}

inline ShellResult solve(const std::filesystem::path& folder) {
  return shell("sh '" + (folder / "Allrun").string() + "'");
}

}  // namespace clogflow
