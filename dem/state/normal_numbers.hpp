// Normal random numbers that belong to something: no order in which they must be drawn.
#pragma once

#include <array>
#include <cstdint>

namespace clogflow {

/// What a normal number belongs to: nothing else decides it.
struct NoiseCounter {
  std::uint64_t seed = 0;
  std::uint32_t stream = 1;  ///< one for each use; 0 belongs to coupling/base/random_stream
  std::uint32_t draw = 0;    ///< number of the draw within it
  std::int64_t owner = 0;    ///< for instance the id of a particle
};

/// Three independent normal numbers of mean 0 and variance 1, by Box and Muller; at most 6.7 in size, since
/// the uniform ones have 32 bits.
std::array<double, 3> normal_numbers(const NoiseCounter& counter);

}  // namespace clogflow
