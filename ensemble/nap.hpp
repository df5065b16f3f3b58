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
  void operator()() {
    std::this_thread::sleep_for(next_);
    next_ = std::min(2 * next_, longest);
  }

private:
  static constexpr std::chrono::microseconds longest{20'000};
  std::chrono::microseconds next_{50};
};

}  // namespace clogflow
