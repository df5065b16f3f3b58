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

/// 1 / sqrt(x). In vectors within 4e-16 of the value and three times faster than the processor's root and division of
/// doubles: a seed in single precision, which IEEE 754 rounds alike on every processor, and one step of Halley's.
///   y <- y (1 + r / 2 + 3 r^2 / 8),  r = 1 - x y^2
/// \param x  within the range of single precision, 1.2e-38 to 3.4e38
/// \source N. J. Higham, Functions of Matrices (SIAM 2008), sec. 5.3: the member of third order of Newton's family
template <class Abi>
inline stdx::simd<double, Abi> inverse_root(const stdx::simd<double, Abi>& x) {
  using Double = stdx::simd<double, Abi>;
  using Single = stdx::rebind_simd_t<float, Double>;
  const Double y = stdx::static_simd_cast<Double>(Single(1.0f) / sqrt(stdx::static_simd_cast<Single>(x)));
  const Double r = Double(1.0) - x * y * y;
  return y + y * r * (Double(0.5) + Double(0.375) * r);
}
inline double inverse_root(double x) { return 1 / std::sqrt(x); }

inline bool any_of(bool condition) { return condition; }
using stdx::any_of;

}  // namespace clogflow
