#include "dem/state/counter_random.hpp"

#include <cmath>
#include <numbers>

namespace clogflow {

std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> c, std::array<std::uint32_t, 2> key) {
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

std::array<double, 3> normal_numbers(const NoiseCounter& n) {
  const auto owner = static_cast<std::uint64_t>(n.owner);
  const auto low = [](std::uint64_t word) { return static_cast<std::uint32_t>(word); };
  const auto bits = philox({low(owner), low(owner >> 32), n.draw, n.stream}, {low(n.seed), low(n.seed >> 32)});
  // In (0, 1): the logarithm of 0 is never asked for.
  const auto uniform = [&](int k) { return (bits[k] + 0.5) * 0x1p-32; };
  const double length = std::sqrt(-2 * std::log(uniform(0))), angle = 2 * std::numbers::pi * uniform(1);
  return {length * std::cos(angle), length * std::sin(angle),
          std::sqrt(-2 * std::log(uniform(2))) * std::cos(2 * std::numbers::pi * uniform(3))};
}

}  // namespace clogflow
