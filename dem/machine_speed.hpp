// How fast this machine is, tried out briefly before a cost is promised.
#pragma once

namespace clog {

/// Instructions per second of one core in this program's own loops: a lattice of 512 touching spheres with all
/// contact terms, lubrication and drag takes steps until enough processor time has passed. The quarter of the
/// steps that other programs on the machine disturbed least counts.
/// \param duration  processor time to spend [s]
/// \return [1/s]
double instructions_per_second(double duration);

/// Instructions per particle and step of that lattice (avx2, `tests/benchmarks/term_costs`, last row).
inline constexpr double lattice_instructions = 520;

}  // namespace clog
