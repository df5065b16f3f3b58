// The particles: for each its state, its number and whether it has passed.
#pragma once

#include <cstdint>
#include <vector>

#include "coupling/base/vector.hpp"
#include "dem/kernels/kernels.hpp"

namespace clogflow {

/// A particle to be added.
struct Particle {
  std::int64_t id = 0;
  int species = 0;                ///< place in particles.species
  double radius = 0;              ///< [m]
  double mass = 0;                ///< inertial, mass scale included [kg]
  double inertia = 0;             ///< moment of inertia, both scales included [kg m2]
  double x = 0, y = 0, z = 0;     ///< [m]
  double vx = 0, vy = 0, vz = 0;  ///< [m/s]
  double wx = 0, wy = 0, wz = 0;  ///< [rad/s]

  Vec3 position() const { return {x, y, z}; }
  Vec3 velocity() const { return {vx, vy, vz}; }
};

/// Of a particle that moves with v and turns with w: m v^2 / 2 + I w^2 / 2 [J]
inline double kinetic_energy(const ParticleState& p, const Vec3& v, const Vec3& w) {
  return 0.5 * p.mass * dot(v, v) + 0.5 * p.inertia * dot(w, w);
}

struct Particles {
  std::vector<std::int64_t> id;  ///< given once; a column that goes back brings its own with it
  std::vector<ParticleState> states;
  std::vector<std::uint8_t> passed;  ///< 1 once the passage plane was crossed
  std::vector<std::uint8_t> species;

  std::size_t size() const { return id.size(); }
  const ParticleState& operator[](std::size_t i) const { return states[i]; }
  ParticleState& operator[](std::size_t i) { return states[i]; }

  template <class Archive>
  void exchange(Archive& archive) {
    archive(id, states, passed, species);
  }

  /// Whether particles read from a file have all their numbers, none of them impossible.
  bool valid(double largest_radius) const;

  void add(const Particle& particle);

  void clear_loads();

  /// Takes the particles in the given order; those not named are dropped.
  void reorder(const std::vector<int>& order);
};

/// Of the velocities as they are kept, half a step before the places. A pack that shakes from one step to the next
/// has it, and at whole steps none [J]
double half_step_energy(const Particles& particles);

inline PairPlace<double> pair_place(const Particles& p, int i, int j) {
  return {{p[i].x - p[j].x, p[i].y - p[j].y, p[i].z - p[j].z}, p[i].radius, p[j].radius};
}

/// The states as the kernels see them; valid until particles are added or reordered.
ParticlePointers pointers(Particles& particles);

}  // namespace clogflow
