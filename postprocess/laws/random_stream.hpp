// Random numbers for resampling: one independent, reproducible stream for every replicate.
#pragma once

#include <cstddef>
#include <cstdint>

#include "coupling/base/unit_uniform.hpp"

namespace clogflow::postprocess {

/// SplitMix64 (Steele, Lea & Flood 2014). A stream is named by (seed, number), so that replicate 17
/// draws the same numbers on any number of threads.
class RandomStream {
public:
  RandomStream(std::uint64_t seed, std::uint64_t number) : state_(mixed(mixed(seed) + increment * (number + 1))) {}

  std::uint64_t next() {
    state_ += increment;
    return mixed(state_);
  }

  /// Uniform in [0, 1), 53 bits.
  double uniform() { return unit_uniform(next()); }

  /// Uniform in 0 ... count - 1; the bias, count / 2^53, is far below what a sample can show.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(uniform() * static_cast<double>(count)); }

private:
  static constexpr std::uint64_t increment = 0x9e3779b97f4a7c15;

  static std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
};

}  // namespace clogflow::postprocess
