// Initial particles from a CSV file.
#pragma once

#include <string>
#include <vector>

#include "coupling/scene/scene.hpp"
#include "dem/state/particles.hpp"

namespace clogflow {

/// What a file of initial particles holds.
struct InitialParticles {
  std::vector<Particle> particles;
  std::vector<int> lines;  ///< of the file, of each particle
  std::string note;        ///< one line on columns that were left out, or empty
};

/// Reads particles.initial: one line a particle under a header, see particle_table.hpp; x, y and z must be
/// there, other missing columns are zero, a missing radius is half the diameter. Lines that begin with # are
/// comments; the header may be one. Masses are left to Model::particle. Empty without a file.
/// \throws Error with file and line on a header that is none, a bad number or a radius that is not positive
InitialParticles read_initial_file(const Scene& scene);

/// Its particles alone.
std::vector<Particle> read_initial_particles(const Scene& scene);

/// A sphere at rest, its mass and moment of inertia scaled as the scene says.
Particle particle_at_rest(const Scene& scene, double radius);
Particle particle_at_rest(const Scene& scene, double radius, double density);

}  // namespace clogflow
