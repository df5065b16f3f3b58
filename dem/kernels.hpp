// The hot loops behind one table of functions, compiled once per instruction set.
#pragma once

#include <cstddef>
#include <cstdint>

#include "dem/grid_place.hpp"
#include "dem/physics/contact.hpp"

namespace clog {

/// Plain pointers into Particles, so that the kernels instantiate no library code.
struct ParticlePointers {
  const double *radius, *mass, *inertia;
  double *x, *y, *z, *vx, *vy, *vz, *wx, *wy, *wz;
  double *fx, *fy, *fz, *tx, *ty, *tz;
  double* state;  ///< of the first record: x y z r, vx vy vz m, wx wy wz 0
  double* loads;  ///< of the first record: fx fy fz 0, tx ty tz 0
  std::size_t count;
};

/// Doubles in a particle's record, which holds all that a contact asks for: four at a time make one
/// load and a transposition of what would be sixteen single loads for four contacts.
inline constexpr int record_stride = 20, record_loads = 12;

/// Doubles in the widest vector of any instruction set here; arrays that are read in whole vectors
/// are padded by it.
inline constexpr std::size_t widest_vector = 8;

/// Rows of a list: two particles, or a particle and a plane, and the candidate that they are.
struct RowPointers {
  int *first, *second, *candidate;
  std::size_t* count;
};

/// A ContactSet. There is room for every row of `touching` in `watched` and the other way round.
struct ContactPointers {
  RowPointers touching;
  double* spring[7];  ///< of the touching: sliding x y z, rolling x y z, torsion, each side by side
  RowPointers watched;  ///< candidates that may begin to touch before the next sorting
  int* changed;         ///< scratch, as long as the rows
  const int *film_first, *film_second;  ///< candidates that may lubricate and cannot touch
  std::size_t film_count;
  bool watched_lubricate;  ///< whether the watched can have a film
};

struct LubricationLaw {
  double viscosity = 0;  ///< [Pa s]; 0: no lubrication
  double nearest = 0;    ///< 2 xi: below, the force is absent or held [m]
  double farthest = 0;   ///< [m]
  bool clamp = false;    ///< hold the force of `nearest` below it, down to contact

  /// Smallest gap with a film [m].
  double least() const { return clamp ? 0 : nearest; }
};

/// What a pass over contacts saw.
struct ContactTally {
  std::int64_t contacts = 0;
  double largest_overlap = 0;  ///< [m]
};

/// Every index array is padded to whole vectors with valid indices.
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
  const double* speed_up;                             ///< of each strip: 1 / eps
  const double* drag_per_radius;                      ///< of each strip [N s/m2]
  double *ux, *uy, *uz, *drag;                        ///< [m/s], [N s/m]
};

/// Drag, kick and drift of every particle: v += a kick, x += v drift.
struct AdvanceTask {
  ParticlePointers particles;
  const double *ux, *uy, *uz;  ///< fluid velocity at the particles [m/s]
  const double* drag;          ///< coefficient c [N s/m]; nullptr: no drag
  const double* turn;          ///< coefficient of the viscous torque [N m s]; nullptr: none
  const double *sx, *sy, *sz;  ///< half the fluid's vorticity [rad/s], with `turn`
  double body_force[3];        ///< [N]
  double kick, drift;          ///< [s]
  bool implicit_drag;
  double passage;  ///< place of the passage plane [m]
};

struct AdvanceTally {
  double largest_speed = 0;  ///< [m/s]; NaN if any is
  double drag_work = 0;      ///< [J]
  double body_work = 0;      ///< [J]
  bool crossed = false;      ///< whether any particle passed x = passage, forwards
};

struct Kernels {
  const char* name;                         ///< instruction set
  int lanes;                                ///< doubles in a vector
  void (*pack)(const ParticlePointers&);    ///< state from the arrays; clears the packed loads
  void (*unpack)(const ParticlePointers&);  ///< packed loads into fx ... tz
  ContactTally (*collide_pairs)(const PairTask&, ContactTerms);
  ContactTally (*collide_planes)(const PlaneTask&, ContactTerms);
  void (*sample_nearest)(const FlowTask&);
  AdvanceTally (*advance)(const AdvanceTask&);
};

/// The table for the best instruction set that both this program and this processor have.
/// \param wanted  name of an instruction set, or empty for the best; CLOG_ISA in the environment
/// does
///                the same
/// \throws Error if it is unknown or the processor lacks it
const Kernels& select_kernels(const char* wanted = nullptr);

extern const Kernels kernels_x86_64;
extern const Kernels kernels_avx2;
extern const Kernels kernels_avx512;

}  // namespace clog
