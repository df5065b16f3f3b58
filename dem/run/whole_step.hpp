// Velocities, forces and energies at the time of the places; all after the forces of that time.
#pragma once

#include "dem/run/run_state.hpp"

namespace clogflow {

Vec3 total_force(const RunState& state, int i);   ///< [N]
Vec3 velocity_now(const RunState& state, int i);  ///< [m/s]
Vec3 spin_now(const RunState& state, int i);      ///< without the fluid's torque in the last half step [rad/s]

double kinetic_energy(const RunState& state);  ///< [J]
double elastic_energy(const RunState& state);  ///< of all springs [J]

}  // namespace clogflow
