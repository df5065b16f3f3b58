// The hot loops behind one table of functions, compiled once per instruction set.
#pragma once

#include <cstddef>
#include <cstdint>

#include "dem/physics/contact.hpp"

namespace clog {

/// Plain pointers into Particles, so that the kernels instantiate no library code.
struct ParticlePointers {
  const double *radius, *mass, *inertia;
  double *x, *y, *z, *vx, *vy, *vz, *wx, *wy, *wz;
  double *fx, *fy, *fz, *tx, *ty, *tz;
  std::size_t count;
};

/// Springs of many contacts, one array per component (sliding x y z, rolling x y z, torsion).
struct SpringPointers {
  double* component[7];
  std::uint8_t* touching;  ///< 1 where the springs belong to a contact of the last step
};

struct LubricationLaw {
  double viscosity = 0;  ///< [Pa s]; 0: no lubrication
  double nearest = 0;    ///< 2 xi: below, the force is absent or held [m]
  double farthest = 0;   ///< [m]
  bool clamp = false;    ///< hold the force of `nearest` below it, down to contact
};

/// What a pass over contacts saw.
struct ContactTally {
  std::int64_t contacts = 0;
  double largest_overlap = 0;  ///< [m]
};

/// Pairs that may touch before the list is rebuilt.
struct PairTask {
  ParticlePointers particles;
  const int *first, *second;
  std::size_t count;
  SpringPointers springs;
  int *touching, *lubricated;  ///< scratch, `count` long
  ContactLaw law;
  LubricationLaw lubrication;
  double dt;
};

/// Pairs that can only lubricate before the list is rebuilt.
struct FarTask {
  ParticlePointers particles;
  const int *first, *second;
  std::size_t count;
  LubricationLaw lubrication;
};

/// Particles that can meet the inside of one plane wall.
struct PlaneTask {
  ParticlePointers particles;
  const int* particle;
  const double *nx, *ny, *nz, *offset;  ///< n . x = offset on the plane
  std::size_t count;
  SpringPointers springs;
  int *touching, *lubricated;
  ContactLaw law;
  LubricationLaw lubrication;
  double dt;
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
};

struct AdvanceTally {
  double largest_speed = 0;  ///< [m/s]; NaN if any is
  double drag_work = 0;      ///< [J]
  double body_work = 0;      ///< [J]
};

struct Kernels {
  const char* name;  ///< instruction set
  int lanes;         ///< doubles in a vector
  ContactTally (*collide_pairs)(const PairTask&, ContactTerms);
  void (*lubricate_far)(const FarTask&);
  ContactTally (*collide_planes)(const PlaneTask&, ContactTerms);
  AdvanceTally (*advance)(const AdvanceTask&);
};

/// The table for the best instruction set that both this program and this processor have.
/// \param wanted  name of an instruction set, or empty for the best; CLOG_ISA in the environment does
///                the same
/// \throws Error if it is unknown or the processor lacks it
const Kernels& select_kernels(const char* wanted = nullptr);

extern const Kernels kernels_x86_64;
extern const Kernels kernels_avx2;
extern const Kernels kernels_avx512;

}  // namespace clog
