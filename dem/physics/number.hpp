// What a formula may do with its number type, be it `double` or a SIMD vector of doubles.
#pragma once

#include <cmath>
#include <experimental/simd>

#include "coupling/base/vector.hpp"

namespace clogflow {

namespace stdx = std::experimental;

using std::cbrt;
using std::max;
using std::min;
using std::sqrt;

/// `yes` where the condition holds, `no` elsewhere.
inline double select(bool condition, double yes, double no) { return condition ? yes : no; }

template <class T, class Abi>
inline stdx::simd<T, Abi> select(const stdx::simd_mask<T, Abi>& condition, stdx::simd<T, Abi> yes,
                                 stdx::simd<T, Abi> no) {
#ifdef __clang__
  // Compiled by clang for AVX-512, where() of libstdc++ 12 assigns nothing.
  return stdx::simd<T, Abi>([&](auto k) -> T { return condition[k] ? yes[k] : no[k]; });
#else
  stdx::where(condition, no) = yes;
  return no;
#endif
}

inline bool any_of(bool condition) { return condition; }
using stdx::any_of;

}  // namespace clogflow
