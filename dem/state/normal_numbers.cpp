#include "dem/state/normal_numbers.hpp"

#include <cmath>
#include <numbers>

#include "coupling/base/philox.hpp"

namespace clogflow {

std::array<double, 3> normal_numbers(const NoiseCounter& n) {
  const auto owner = static_cast<std::uint64_t>(n.owner);
  const auto bits =
      philox({low_word(owner), high_word(owner), n.draw, n.stream}, {low_word(n.seed), high_word(n.seed)});
  // In (0, 1): the logarithm of 0 is never asked for.
  const auto uniform = [&](int k) { return (bits[k] + 0.5) * 0x1p-32; };
  const double length = std::sqrt(-2 * std::log(uniform(0))), angle = 2 * std::numbers::pi * uniform(1);
  return {length * std::cos(angle), length * std::sin(angle),
          std::sqrt(-2 * std::log(uniform(2))) * std::cos(2 * std::numbers::pi * uniform(3))};
}

}  // namespace clogflow
