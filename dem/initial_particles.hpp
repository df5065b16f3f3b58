// Initial particles from a CSV file.
#pragma once

#include <vector>

#include "coupling/scene.hpp"
#include "dem/particles.hpp"

namespace clog {

/// Reads particles.initial: a header of x,y,z,radius,vx,vy,vz,wx,wy,wz in SI units, columns in any
/// order; missing columns are zero, a missing radius is half the diameter. Lines that begin with #
/// are comments. Masses are left to Model::particle. Empty without a file.
/// \throws Error with file and line on an unknown column, a bad number or a radius that is not positive
std::vector<Particle> read_initial_particles(const Scene& scene);

}  // namespace clog
