// The particles: one array per quantity, all of equal length.
#pragma once

#include <cstdint>
#include <vector>

#include "dem/kernels.hpp"

namespace clog {

/// State of one particle, for adding and reading.
struct Particle {
  std::int64_t id = 0;
  double radius = 0;                  ///< [m]
  double mass = 0;                    ///< inertial, mass scale included [kg]
  double inertia = 0;                 ///< moment of inertia, both scales included [kg m2]
  double x = 0, y = 0, z = 0;         ///< [m]
  double vx = 0, vy = 0, vz = 0;      ///< [m/s]
  double wx = 0, wy = 0, wz = 0;      ///< [rad/s]
};

struct Particles {
  std::vector<std::int64_t> id;       ///< never used twice in a run
  std::vector<double> radius, mass, inertia;
  std::vector<double> x, y, z;        ///< at time n
  std::vector<double> vx, vy, vz;     ///< half a step before: the leapfrog form of velocity Verlet
  std::vector<double> wx, wy, wz;
  std::vector<double> fx, fy, fz;     ///< sum of the forces but drag and body force [N]
  std::vector<double> tx, ty, tz;     ///< sum of the torques [N m]
  std::vector<double> state, loads;   ///< the hot loops' packed copies, see ParticlePointers
  std::vector<std::uint8_t> passed;   ///< 1 once the passage plane was crossed

  std::size_t size() const { return id.size(); }

  template <class Archive>
  void exchange(Archive& archive) {
    archive(id, radius, mass, inertia, x, y, z, vx, vy, vz, wx, wy, wz, fx, fy, fz, tx, ty, tz, passed);
  }

  /// Whether particles read from a file have all their numbers, none of them impossible.
  bool sound(double largest_radius) const;

  void add(const Particle& particle);

  /// Takes the particles in the given order; those not named are dropped.
  void reorder(const std::vector<int>& order);
};

/// The arrays as the kernels see them; valid until particles are added or reordered.
ParticlePointers pointers(Particles& particles);

}  // namespace clog
