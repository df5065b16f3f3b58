// Vectors of doubles, in registers and in memory. Everything in this folder's
// headers is compiled once per instruction set, under flags that no other file has; it must
// therefore use nothing that another file could also instantiate (no containers).
#pragma once

#include "dem/kernels/kernels.hpp"

namespace clogflow {
namespace {

using Lanes = stdx::native_simd<double>;
constexpr int lanes = static_cast<int>(Lanes::size());
using Index = const int*;

/// Vectors in memory, aligned as a double is. Read and written through these types and not as
/// bytes: bytes could be anybody's, so that after each store the compiler would have to read all
/// indices anew.
typedef double LanesInMemory __attribute__((vector_size(8 * lanes), aligned(8)));

[[gnu::always_inline]] inline Lanes load_lanes(const double* values) {
  return Lanes(*reinterpret_cast<const LanesInMemory*>(values));
}

[[gnu::always_inline]] inline void store_lanes(double* values, const Lanes& amount) {
  *reinterpret_cast<LanesInMemory*>(values) = static_cast<LanesInMemory>(amount);
}

/// Calls each(k) for the first `used` lanes; almost every vector is full, and then k is known to the compiler.
template <class Each>
[[gnu::always_inline]] inline void for_lanes(int used, const Each& each) {
  if (used == lanes) {
#pragma GCC unroll 8
    for (int k = 0; k < lanes; ++k) each(k);
  } else {
    for (int k = 0; k < used; ++k) each(k);
  }
}

[[gnu::always_inline]] inline Lanes load(const double* values, Index at) {
  return Lanes([&](auto k) { return values[at[k]]; });
}

[[gnu::always_inline]] inline int lanes_left(std::size_t from, std::size_t count) {
  const std::size_t left = count - from;
  return left < static_cast<std::size_t>(lanes) ? static_cast<int>(left) : lanes;
}

/// Zero in the spare lanes, whose indices are padding.
[[gnu::always_inline]] inline Lanes used_lanes(const Lanes& values, int used) {
  if (used == lanes) return values;
  return Lanes([&](auto k) { return static_cast<int>(k) < used ? values[k] : 0.0; });
}

/// Reads or writes a stretch of an array that may end before the vector does.
[[gnu::always_inline]] inline Lanes load_part(const double* values, int used) {
  if (used == lanes) return load_lanes(values);
  return Lanes([&](auto k) {
    const int lane = static_cast<int>(k);
    return values[lane < used ? lane : used - 1];
  });
}

[[gnu::always_inline]] inline void store_part(double* values, Lanes amount, int used) {
  if (used == lanes) {
    store_lanes(values, amount);
  } else {
    for (int k = 0; k < used; ++k) values[k] = amount[k];
  }
}

}  // namespace
}  // namespace clogflow
