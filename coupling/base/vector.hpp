// The vector of three lengths, velocities or forces, in doubles or in SIMD vectors of doubles.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace clogflow {

/// Three numbers of a type. What a kernel does lane by lane is the operators, dot and cross; the members below are for
/// one vector of doubles, in the order of operations of Eigen's of the same names.
template <class Real>
struct Vector {
  Real x, y, z;

  Vector() = default;
  constexpr Vector(const Real& a, const Real& b, const Real& c) : x(a), y(b), z(c) {}
  explicit Vector(const std::array<Real, 3>& of) : Vector(of[0], of[1], of[2]) {}
  explicit Vector(const Real* of) : Vector(of[0], of[1], of[2]) {}

  static constexpr Vector Constant(Real value) { return {value, value, value}; }
  static constexpr Vector Zero() { return Constant(Real(0)); }

  Real& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  const Real& operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }

  std::array<Real, 3> array() const { return {x, y, z}; }

  friend Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vector operator*(const Real& s, const Vector& a) { return {s * a.x, s * a.y, s * a.z}; }
  friend Vector operator*(const Vector& a, const Real& s) { return s * a; }
  friend Vector operator/(const Vector& a, const Real& s) { return {a.x / s, a.y / s, a.z / s}; }
  friend Vector operator-(const Vector& a) { return {-a.x, -a.y, -a.z}; }
  friend bool operator==(const Vector&, const Vector&) = default;

  Vector& operator+=(const Vector& b) { return *this = *this + b; }
  Vector& operator-=(const Vector& b) { return *this = *this - b; }
  Vector& operator*=(const Real& s) { return *this = s * *this; }
  Vector& operator/=(const Real& s) { return *this = *this / s; }

  Real squaredNorm() const { return dot(*this, *this); }
  Real norm() const { return std::sqrt(squaredNorm()); }

  /// Of length 1; a vector without length stays as it is.
  Vector normalized() const {
    const Real square = squaredNorm();
    return square > 0 ? *this / std::sqrt(square) : *this;
  }

  Vector cwiseMin(const Vector& b) const { return {std::min(x, b.x), std::min(y, b.y), std::min(z, b.z)}; }
  Vector cwiseMax(const Vector& b) const { return {std::max(x, b.x), std::max(y, b.y), std::max(z, b.z)}; }
  Vector cwiseAbs() const { return {std::abs(x), std::abs(y), std::abs(z)}; }
  Real minCoeff() const { return std::min({x, y, z}); }
  Real maxCoeff() const { return std::max({x, y, z}); }
  bool allFinite() const { return std::isfinite(x) && std::isfinite(y) && std::isfinite(z); }

  /// Whether no component is beyond a corner of the box; false where one is not a number.
  bool within(const Vector& low, const Vector& high) const {
    return x >= low.x && y >= low.y && z >= low.z && x <= high.x && y <= high.y && z <= high.z;
  }
};

template <class Real>
Real dot(const Vector<Real>& a, const Vector<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Real>
Vector<Real> cross(const Vector<Real>& a, const Vector<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

using Vec3 = Vector<double>;

}  // namespace clogflow
