// How fast this machine is, tried out briefly before a cost is promised.
#pragma once

namespace clogflow {

/// Instructions per particle and step of the lattice (AVX2; callgrind of compute_forces and advance in the test
/// MachineSpeed).
inline constexpr double lattice_instructions = 377;

/// An instruction in a pack of the channel takes so much longer than one in the lattice, which has no walls and lies in
/// memory in order: from processor times of both, in turn, at five scenes (docs/reports/performance.md). [-]
inline constexpr double pack_slowness = 1.4;

/// Instructions per second of one core in this program's own loops, for a pack of a channel: a lattice of 512 touching
/// spheres with all contact terms, lubrication and drag takes steps until enough processor time has passed. The quarter
/// of the steps that other programs on the machine disturbed least counts.
/// \param duration  processor time to spend [s]
/// \return [1/s]
double instructions_per_second(double duration);

}  // namespace clogflow
