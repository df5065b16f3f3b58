// Runs another program and collects what it says.
#pragma once

#include <string>
#include <vector>

namespace clog::postprocess {

struct ChildResult {
  int status = 0;      ///< exit status; 128 + signal when a signal ended it
  std::string output;  ///< standard output and error together
};

/// Looks the program up in PATH unless its name holds a slash; no shell is involved.
/// \throws Error when it cannot be started
ChildResult run_program(const std::vector<std::string>& words);

}  // namespace clog::postprocess
