// Random numbers drawn one after the other.
#pragma once

#include <cstddef>
#include <cstdint>

#include "coupling/base/philox.hpp"

namespace clogflow {

/// A stream of random numbers, named by a seed and a number: replicate 17 of a resampling draws the same on any number
/// of threads, and the places of new particles are the same on every platform. Not the standard library's
/// distributions: their results differ between compilers.
class RandomStream {
public:
  /// \param number  below 2^32; the rest of the counters belongs to dem/state/normal_numbers
  RandomStream(std::uint64_t seed, std::uint64_t number) : seed_(seed), number_(number) {}
  explicit RandomStream(std::uint64_t seed) : RandomStream(seed, 0) {}

  std::uint64_t next() {
    const auto words = philox({low_word(drawn_), high_word(drawn_), low_word(number_), high_word(number_)},
                              {low_word(seed_), high_word(seed_)});
    ++drawn_;
    return words[0] | std::uint64_t{words[1]} << 32;
  }

  /// Uniform in [0, 1), from the upper 53 bits.
  double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }

  /// Uniform in [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// Uniform in 0 ... count - 1; the bias, count / 2^53, is far below what a sample can show.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(uniform() * static_cast<double>(count)); }

  template <class Archive>
  void exchange(Archive& archive) {
    archive(seed_, number_, drawn_);
  }

private:
  std::uint64_t seed_, number_;
  std::uint64_t drawn_ = 0;
};

}  // namespace clogflow
