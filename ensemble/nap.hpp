// Waiting that costs others nothing.
#pragma once

#include <algorithm>
#include <chrono>
#include <thread>

namespace clogflow {

/// Ranks may share cores, and MPI's own waiting spins: it takes the core from those that are waited for. Naps grow from
/// what a short wait does not notice to what a long one costs nothing.
class Nap {
public:
  /// \param longest  short where others wait for this one to pass something on
  explicit Nap(std::chrono::milliseconds longest) : longest_(longest) {}

  void operator()() {
    std::this_thread::sleep_for(next_);
    next_ = std::min(2 * next_, longest_);
  }

private:
  std::chrono::microseconds longest_, next_{50};
};

}  // namespace clogflow
