// The hot loops behind one table of functions, compiled once per instruction set.
#pragma once

#include <cstddef>
#include <cstdint>

#include "dem/kernels/grid_place.hpp"
#include "dem/physics/contact_law.hpp"
#include "dem/physics/lubrication.hpp"

namespace clogflow {

/// All that a contact asks of a particle and adds to it, in one place in memory: rows of four make
/// one load each, and a transposition of what would be sixteen single loads for four contacts.
struct alignas(32) ParticleState {
  double x = 0, y = 0, z = 0, radius = 0;        ///< at time n [m]
  double vx = 0, vy = 0, vz = 0, mass = 0;       ///< half a step before [m/s], with all scales [kg]
  double wx = 0, wy = 0, wz = 0, inertia = 0;    ///< half a step before [rad/s], with all scales [kg m2]
  double fx = 0, fy = 0, fz = 0, no_force = 0;   ///< sum of the forces but drag and body force [N]
  double tx = 0, ty = 0, tz = 0, no_torque = 0;  ///< sum of the torques [N m]

  Vec3 position() const { return {x, y, z}; }
  Vec3 velocity() const { return {vx, vy, vz}; }
  Vec3 spin() const { return {wx, wy, wz}; }
};

/// Doubles from one particle to the next, and to the loads of the same.
inline constexpr int record_stride = sizeof(ParticleState) / sizeof(double), record_loads = 12;

/// Plain pointers into Particles, so that the kernels instantiate no library code.
struct ParticlePointers {
  ParticleState* particle;
  double *state, *loads;  ///< the same memory, of the first particle from x and from fx on
  const std::uint8_t* species;
  std::size_t count;
};

/// Doubles in the widest vector of any instruction set here.
inline constexpr std::size_t widest_vector = 8;

/// The hot loop asks for the particles of this many vectors ahead, so that they are there when needed.
inline constexpr std::size_t vectors_ahead = 4;

/// Rows of indices are read in whole vectors, and ahead.
inline constexpr std::size_t row_padding = (vectors_ahead + 1) * widest_vector;

/// Springs of as many contacts as the widest vector holds: one stream through memory instead of seven,
/// which would also fall on each other in the nearest cache.
struct alignas(64) SpringBlock {
  double part[7][widest_vector];  ///< sliding x y z, rolling x y z, torsion
};

/// One of the seven parts of the springs of row `row`; those of a vector's rows stand side by side.
inline double& spring_part(SpringBlock* springs, int part, std::size_t row) {
  return springs[row / widest_vector].part[part][row % widest_vector];
}

/// Rows of a list: two particles, or a particle and a plane, and the candidate that they are.
struct RowPointers {
  int *first, *second, *candidate;
  std::size_t* count;
};

/// A ContactSet. There is room for every row of `touching` in `watched` and the other way round.
struct ContactPointers {
  RowPointers touching;
  SpringBlock* springs;                 ///< of the touching
  RowPointers watched;                  ///< candidates that may begin to touch before the next sorting
  int* changed;                         ///< scratch, as long as the rows
  const int *film_first, *film_second;  ///< candidates that may lubricate and cannot touch
  std::size_t film_count;
  bool watched_lubricate;  ///< whether the watched can have a film
};

/// What a pass over contacts saw.
struct ContactTally {
  std::int64_t contacts = 0;
  double largest_overlap = 0;  ///< [m]
};

/// Every index array is padded by row_padding valid indices.
struct PairTask {
  ParticlePointers particles;
  ContactPointers contacts;
  ContactLaw law;
  LubricationLaw lubrication;
  double dt;
  double radius, mass;  ///< of every particle, if all are equal; else 0
};

/// Contacts with the inside of plane walls.
struct PlaneTask {
  ParticlePointers particles;
  const double *nx, *ny, *nz, *offset;  ///< of each slot: n . x = offset on the plane
  ContactPointers contacts;             ///< rows of particles and slots
  ContactLaw law;
  LubricationLaw lubrication;
  double dt;
};

/// Velocity of the fluid and drag coefficient of every particle, from the nearest point of a grid
/// and the strip that the particle is in.
struct FlowTask {
  ParticlePointers particles;
  const float* velocity;                ///< V0, three numbers a point, x fastest [m/s]
  double origin[3], points_per_length;  ///< [m], [1/m]
  int points[3];
  double strip_start, strips_per_length, last_strip;  ///< [m], [1/m]
  double neck;                                        ///< from this x on the strip after the last counts [m]
  const double* speed_up;                             ///< of each strip: 1 / eps
  const double* drag_per_radius;                      ///< of each strip [N s/m2]
  double *ux, *uy, *uz, *drag;                        ///< [m/s], [N s/m]
};

/// Drag, kick and drift of every particle: v += a kick, x += v drift. The loads that did it are then
/// cleared for the next step.
struct AdvanceTask {
  ParticlePointers particles;
  const double *ux, *uy, *uz;  ///< fluid velocity at the particles [m/s]
  const double* drag;          ///< coefficient c [N s/m]; nullptr: no drag
  const double* turn;          ///< coefficient of the viscous torque [N m s]; nullptr: none
  const double *sx, *sy, *sz;  ///< half the fluid's vorticity [rad/s], with `turn`
  double body_force[3];        ///< [N]
  double weight_per_mass[3];   ///< beside body_force, where it differs between particles [m/s2]
  bool weighs;                 ///< whether there is any
  double buoyancy[3];          ///< against it, per cubed radius, where densities differ [N/m3]
  bool floats;                 ///< whether there is any
  double kick, drift;          ///< [s]
  double mass, inertia;        ///< of every particle, if all are equal; else 0
  bool implicit_drag;
  double passage;   ///< place of the passage plane [m]
  double too_fast;  ///< a particle as fast as this keeps its loads, so that they can be named [m/s]
};

struct AdvanceTally {
  double largest_speed = 0;  ///< [m/s]; NaN if any is
  double drag_work = 0;      ///< [J]
  double body_work = 0;      ///< [J]
  bool crossed = false;      ///< whether any particle passed x = passage, forwards
};

struct Kernels {
  const char* name;  ///< instruction set
  int lanes;         ///< doubles in a vector
  ContactTally (*collide_pairs)(const PairTask&, ContactTerms);
  ContactTally (*collide_planes)(const PlaneTask&, ContactTerms);
  void (*sample_nearest)(const FlowTask&);
  AdvanceTally (*advance)(const AdvanceTask&);
};

/// The table for the fastest instruction set that both this program and this processor have: AVX-512, then AVX2.
/// \param wanted  name of an instruction set, or empty for the fastest; CLOG_ISA in the environment
///                does the same
/// \throws Error if it is unknown or the processor lacks it
const Kernels& select_kernels(const char* wanted = nullptr);

extern const Kernels kernels_x86_64;
extern const Kernels kernels_avx2;
extern const Kernels kernels_avx512;

}  // namespace clogflow
