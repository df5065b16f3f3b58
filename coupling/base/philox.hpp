// The one generator of random words: a function of a key and a counter, without a state.
#pragma once

#include <array>
#include <cstdint>

namespace clogflow {

/// Philox 4x32 with ten rounds: four words that look random for each counter and key. Whoever names its counters
/// draws them in any order, on any number of threads, and a saved run needs to keep nothing but where it stood.
/// \source J. K. Salmon, M. A. Moraes, R. O. Dror & D. E. Shaw, "Parallel random numbers: as easy as
///         1, 2, 3", SC'11
constexpr std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> c, std::array<std::uint32_t, 2> key) {
  constexpr int rounds = 10;
  constexpr std::uint64_t multiplier[2] = {0xD2511F53, 0xCD9E8D57};
  constexpr std::uint32_t weyl[2] = {0x9E3779B9, 0xBB67AE85};
  for (int round = 0; round < rounds; ++round) {
    const std::uint64_t a = multiplier[0] * c[0], b = multiplier[1] * c[2];
    c = {static_cast<std::uint32_t>(b >> 32) ^ c[1] ^ key[0], static_cast<std::uint32_t>(b),
         static_cast<std::uint32_t>(a >> 32) ^ c[3] ^ key[1], static_cast<std::uint32_t>(a)};
    key[0] += weyl[0], key[1] += weyl[1];
  }
  return c;
}

/// A number of 64 bits as the two words that a counter or key takes.
constexpr std::uint32_t low_word(std::uint64_t number) { return static_cast<std::uint32_t>(number); }
constexpr std::uint32_t high_word(std::uint64_t number) { return static_cast<std::uint32_t>(number >> 32); }

}  // namespace clogflow
