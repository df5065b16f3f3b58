// Random numbers that are a function of a counter: no state, no order in which they must be drawn.
#pragma once

#include <array>
#include <cstdint>

namespace clogflow {

/// Philox 4x32 with ten rounds: four words that look random for each counter and key.
/// \source J. K. Salmon, M. A. Moraes, R. O. Dror & D. E. Shaw, "Parallel random numbers: as easy as
///         1, 2, 3", SC'11
std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key);

/// What a normal number belongs to: nothing else decides it.
struct NoiseCounter {
  std::uint64_t seed = 0;
  std::uint32_t stream = 0;  ///< one for each use
  std::uint32_t draw = 0;    ///< number of the draw within it
  std::int64_t owner = 0;    ///< for instance the id of a particle
};

/// Three independent normal numbers of mean 0 and variance 1, by Box and Muller; at most 6.7 in size, since
/// the uniform ones have 32 bits.
std::array<double, 3> normal_numbers(const NoiseCounter& counter);

}  // namespace clogflow
