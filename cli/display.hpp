// How a call of clog run stands, for a person.
#pragma once

#include <chrono>

#include "dem/run/progress.hpp"
#include "ensemble/launch.hpp"
#include "ensemble/standing.hpp"

namespace clogflow::cli {

/// On a terminal a line that renews itself: the run of a lone process, or the seeds of all ranks. Launchers hand the
/// output of ranks on without a terminal: there rank 0 says a line a minute.
class Display {
public:
  explicit Display(const Launch& launch);

  void show(const Progress& run, const Standing& all);

  /// Wipes the line, so that another can be printed in its place.
  void clear();

private:
  using Clock = std::chrono::steady_clock;
  std::string run_line(const Progress& now, double passed);

  bool speaks_, is_terminal_, is_alone_;
  double rate_ = 0;        // particle-steps per second of late
  double share_rate_ = 0;  // share of the simulated time per second of late
  Progress last_;
  Clock::time_point begin_ = Clock::now(), last_time_ = begin_;
};

/// "12 of 40 seeds, 2 at work (0 filling, 1 flowing, 1 clogged), ...", with the time left after `seconds` of work.
std::string standing_line(const Standing& all, double seconds);

}  // namespace clogflow::cli
