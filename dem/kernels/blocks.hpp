// Particles that stand together in memory, and in space.
#pragma once

#include <algorithm>
#include <cstddef>

#include "dem/kernels/kernels.hpp"

namespace clogflow {

/// Blocks of equal size, by the number of particles alone: so what is summed block by block does not depend on the
/// number of threads. A few thousand particles are one block; their steps are over before a thread has been woken.
struct Blocks {
  std::size_t particles, length;

  explicit Blocks(std::size_t count) : particles(count) {
    const std::size_t wanted = std::max<std::size_t>(1, count / least_length);
    const std::size_t whole = (count / wanted + widest_vector) / widest_vector * widest_vector;
    length = std::max<std::size_t>(whole, widest_vector);
  }

  /// Particles from which on a block is divided: their records fill the nearer caches of a core.
  static constexpr std::size_t least_length = 4096;

  int count() const { return static_cast<int>(particles == 0 ? 1 : (particles + length - 1) / length); }
  std::size_t begin(int block) const { return std::min(particles, length * static_cast<std::size_t>(block)); }
  std::size_t end(int block) const { return begin(block + 1); }
  int of(int particle) const { return static_cast<int>(static_cast<std::size_t>(particle) / length); }
};

}  // namespace clogflow
