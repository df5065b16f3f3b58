// From random words to random numbers, and which generator makes the words where.
#pragma once

#include <cstdint>

namespace clogflow {

/// Uniform in [0, 1), from the upper 53 bits. Not the standard library's distributions: their results differ between
/// compilers. Three generators, each for what the others cannot do; another one anywhere changes results:
///   dem/state/random               Mersenne twister: places of new particles, drawn one after the other; saved with a
///   run dem/state/counter_random       Philox: noise on the flow, decided by seed, particle and draw, in whatever
///   order postprocess/laws/random_stream SplitMix64: resampling, a stream for every replicate on any number of threads
inline double unit_uniform(std::uint64_t word) { return static_cast<double>(word >> 11) * 0x1p-53; }

}  // namespace clogflow
