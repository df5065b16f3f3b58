// What a formula may do with its number type, be it `double` or a SIMD vector of doubles.
#pragma once

#include <cmath>
#include <experimental/simd>

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

/// A 3-vector of numbers or of SIMD vectors.
template <class Real>
struct Vector {
  Real x, y, z;

  friend Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vector operator*(const Real& s, const Vector& a) { return {s * a.x, s * a.y, s * a.z}; }
  friend Vector operator-(const Vector& a) { return {-a.x, -a.y, -a.z}; }
};

template <class Real>
Real dot(const Vector<Real>& a, const Vector<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Real>
Vector<Real> cross(const Vector<Real>& a, const Vector<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace clogflow
