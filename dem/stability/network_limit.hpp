// The largest stable step of a network of contacts and films: bounded particle by particle, or exact.
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>
#include <Eigen/StdVector>

#include "dem/physics/stiffness.hpp"
#include "dem/state/particles.hpp"

namespace clogflow {

/// The linearised leapfrog is stable if and only if 4 M - dt^2 K - 2 dt C is positive definite, with K and C
/// the sums g k g^T and g c g^T over all springs and dashpots. Young's inequality
///   (g_i.x_i + g_j.x_j)^2 <= (1 + m_i/m_j) (g_i.x_i)^2 + (1 + m_j/m_i) (g_j.x_j)^2
/// splits each pair among its two particles, so one 6 x 6 matrix per particle (translation and rotation
/// coupled through the lever arms) decides: safe, exact for two particles and for one on a wall, and at
/// most sqrt(2) too careful in a pack of equal spheres (2 where damping alone limits).
/// Implicit drag D adds +2 dt D in place of -2 dt C. exact() asks the whole matrix instead, what the springs' tangents
/// allow, all sliders sticking: the scheme is stable while the share
///   s(dt) = largest eigenvalue of (4 M + 2 dt D)^(-1/2) (dt^2 K + 2 dt C) (4 M + 2 dt D)^(-1/2)
/// is below 1. It grows no faster than dt^2, so a stable step over sqrt(s) is stable too, and is the limit where
/// springs alone limit.
/// \source positive definiteness at the root l = -1 of stable_step(); block form of Gershgorin's theorem
class NetworkLimit {
public:
  explicit NetworkLimit(const Particles& particles);

  /// Contact of i with j, or with a wall (j < 0).
  void add_contact(int i, int j, const ContactModes& modes);

  /// Lubrication, c on the rate of approach along the normal [N s/m]; j < 0: a wall.
  void add_film(int i, int j, const Vec3& normal, double coefficient);

  /// Drag on the translation of i [N s/m], and torque on its rotation [N m s].
  struct Drag {
    double translation, rotation;
    bool implicit;
  };
  void add_drag(int i, const Drag& drag);

  struct Bound {
    double step;   ///< largest stable step [s]; infinite if nothing limits it
    int particle;  ///< that limits it; -1: none
  };
  Bound bound() const;

  /// Largest stable step of all together, from a bound of it; too large once in a million random starts.
  /// \return [s], rather too small: by 2 % where springs limit, by up to 5 % where implicit drag nearly holds the films
  double exact(const Bound& bound) const;

  /// Relative width at which the search for the bound stops.
  static constexpr double resolution = 1e-3;

private:
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  template <class Value>
  using Aligned = std::vector<Value, Eigen::aligned_allocator<Value>>;

  void add(int i, const Vector6& direction, double stiffness, double dashpot);
  bool stable(std::size_t i, double dt) const;
  double share(double dt) const;
  Vector6 scaled(int i, const Vec3& shift, const Vec3& turn) const;

  const Particles& particles_;
  Aligned<Matrix6> stiffness_, damping_;  // over mass; rotations in units of length / radius
  Aligned<Vector6> implicit_, explicit_;  // drag over mass
  struct Link {
    int i, j;
    ContactModes modes;
  };
  std::vector<Link> links_;
};

}  // namespace clogflow
