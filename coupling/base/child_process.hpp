// Runs another program and collects what it says.
#pragma once

#include <string>
#include <vector>

namespace clogflow::postprocess {

struct ChildResult {
  int status = 0;      ///< exit status; 128 + signal when a signal ended it
  std::string output;  ///< standard output and error together
};

inline constexpr int nothing_open = -1;

/// Looks the program up in PATH unless its name holds a slash; no shell is involved.
/// \param keep_open  a descriptor that the program has open too
/// \throws Error when it cannot be started
ChildResult run_program(const std::vector<std::string>& words, int keep_open = nothing_open);

}  // namespace clogflow::postprocess
