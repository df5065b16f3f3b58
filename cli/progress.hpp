// Progress of a run for a person: a line that renews itself on a terminal, nothing elsewhere.
#pragma once

#include <chrono>

#include "dem/run/progress.hpp"

namespace clogflow::cli {

class ProgressLine {
public:
  explicit ProgressLine(bool shown) : shown_(shown) {}

  void show(const Progress& progress);

  /// Wipes the line, so that another can be printed in its place.
  void clear();

private:
  using Clock = std::chrono::steady_clock;
  bool shown_, drawn_ = false;
  double rate_ = 0;        // particle-steps per second of late
  double share_rate_ = 0;  // share of the simulated time per second of late
  Progress last_;
  Clock::time_point last_time_ = Clock::now();
};

}  // namespace clogflow::cli
