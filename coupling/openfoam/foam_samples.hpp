// Reads what the sampling of a flow case wrote: velocities at the points of the lattice.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "coupling/openfoam/flow_lattice.hpp"

namespace clogflow {

/// Velocities at the sampled points, [z][y][x]; points that OpenFOAM left out lie in a wall.
struct FoamSamples {
  std::array<int, 3> points{};                 ///< along x, y, z
  std::vector<std::array<float, 3>> velocity;  ///< [m/s]
  std::vector<std::uint8_t> found;             ///< 1 where a value was read

  std::size_t index(int i, int j, int k) const { return (static_cast<std::size_t>(k) * points[1] + j) * points[0] + i; }
};

/// The raw file of the set `lattice`: lines "x y z Ux Uy Uz", # starts a comment.
/// \throws Error naming file and line on a missing file, a line cut short, text that is not a
/// number, a
///         value that is not finite, a point off the lattice, a point given twice
FoamSamples read_foam_samples(const std::filesystem::path& file, const FlowLattice& lattice);

/// The samples file of a field of a case, in the newest time of postProcessing/samples.
/// \throws Error when there is none
std::filesystem::path foam_samples_file(const std::filesystem::path& folder, const char* field = "U");

}  // namespace clogflow
