// Random numbers of a run: decided by the seed alone, the same on every platform.
#pragma once

#include <cstdint>
#include <random>
#include <sstream>
#include <string>

#include "coupling/base/require.hpp"
#include "coupling/base/unit_uniform.hpp"

namespace clogflow {

class Random {
public:
  explicit Random(std::uint64_t seed) {
    // seed_seq mixes, so that neighbouring seeds give unrelated streams.
    std::seed_seq mixed{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)};
    engine_.seed(mixed);
  }

  /// Uniform in [low, high).
  double uniform(double low, double high) { return low + (high - low) * unit_uniform(engine_()); }

  template <class Archive>
  void exchange(Archive& archive) {
    std::ostringstream out;
    out << engine_;
    std::string text = out.str();
    archive(text);
    if constexpr (Archive::loading)
      require(static_cast<bool>(std::istringstream(text) >> engine_), "a saved state holds no random generator");
  }

private:
  std::mt19937_64 engine_;
};

}  // namespace clogflow
