// Independent replicates on all cores, with results that do not depend on how many there are.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace clogflow::postprocess {

/// Results of work(0) ... work(count - 1), in that order. `work` must not share anything it
/// changes, and must not throw.
template <class Work>
auto on_all_cores(std::size_t count, const Work& work) {
  std::vector<decltype(work(std::size_t{}))> results(count);
  std::atomic<std::size_t> next = 0;
  const auto share = [&] {
    for (std::size_t i = next++; i < count; i = next++) results[i] = work(i);
  };
  std::vector<std::jthread> others;
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  for (std::size_t k = 1; k < std::min(cores, count); ++k) others.emplace_back(share);
  share();
  others.clear();
  return results;
}

}  // namespace clogflow::postprocess
