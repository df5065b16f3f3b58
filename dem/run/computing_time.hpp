// Time that a run has taken, over all programs that worked on it: of the clock on the wall, and of the processor,
// which the load of the machine does not lengthen.
#pragma once

#include <chrono>
#include <cmath>
#include <ctime>

namespace clogflow {

class ComputingTime {
public:
  /// What passed until now is not counted.
  void start() { began_ = Clock::now(), processor_began_ = std::clock(); }

  /// Counts until now.
  void lap() {
    seconds_ += std::chrono::duration<double>(Clock::now() - began_).count();
    processor_seconds_ += static_cast<double>(std::clock() - processor_began_) / CLOCKS_PER_SEC;
    start();
  }

  double seconds() const { return seconds_; }                      ///< of the wall clock, until the last lap [s]
  double processor_seconds() const { return processor_seconds_; }  ///< of all threads of this process [s]

  bool valid() const {
    return std::isfinite(seconds_) && seconds_ >= 0 && std::isfinite(processor_seconds_) && processor_seconds_ >= 0;
  }

  template <class Archive>
  void exchange(Archive& archive) {
    archive(seconds_, processor_seconds_);
  }

private:
  using Clock = std::chrono::steady_clock;
  double seconds_ = 0, processor_seconds_ = 0;
  Clock::time_point began_ = Clock::now();
  std::clock_t processor_began_ = std::clock();
};

}  // namespace clogflow
