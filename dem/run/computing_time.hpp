// Wall-clock time that a run has taken, over all programs that worked on it.
#pragma once

#include <chrono>
#include <cmath>

namespace clogflow {

class ComputingTime {
public:
  /// What passed until now is not counted.
  void start() { began_ = Clock::now(); }

  /// \return all seconds counted, until now
  double lap() {
    const std::chrono::duration<double> since = Clock::now() - began_;
    seconds_ += since.count();
    began_ = Clock::now();
    return seconds_;
  }

  bool valid() const { return std::isfinite(seconds_) && seconds_ >= 0; }

  template <class Archive>
  void exchange(Archive& archive) {
    archive(seconds_);
  }

private:
  using Clock = std::chrono::steady_clock;
  double seconds_ = 0;
  Clock::time_point began_ = Clock::now();
};

}  // namespace clogflow
