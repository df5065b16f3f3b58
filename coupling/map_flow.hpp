// From the samples of a solved flow case to the whole channel on a regular grid.
#pragma once

#include <filesystem>

#include "coupling/flow_grid.hpp"
#include "coupling/flow_space.hpp"
#include "coupling/foam_samples.hpp"
#include "coupling/scene.hpp"

namespace clog {

/// The regular grid of a solved flow case, with walls, effective scene, hash and provenance.
/// Velocities are those of OpenFOAM, mirrored where the channel is symmetric, and before the inlet
/// of its mesh those of developed duct flow; nothing is rescaled. Points inside a wall or on it are
/// solid with zero velocity. \throws Error when the case is not solved, is of other inputs than its
/// scene.toml, or its files do
///         not hold what they should
FlowGrid map_flow(const std::filesystem::path& folder);

/// Velocity and solid mask alone: points, origin, spacing, velocity, solid.
/// \throws Error when a point in the fluid has no sample
FlowGrid grid_from_samples(const Scene& scene, const FlowLattice& lattice,
                           const FoamSamples& samples);

/// The same for a channel from a file, where all is sampled; points beside curved walls that the mesh
/// does not reach are solid. \throws Error when they are too many
FlowGrid stl_grid_from_samples(const Scene& scene, const FlowSpace& space, const FoamSamples& samples);

/// What reading between the points costs, root mean square over the points whose neighbours are all
/// fluid, and over `speed` [-]. Trilinear: the mean over a cell of s (1 - s) / 2 = 1/12 of each
/// axis' second difference; nearest: a distance of rms 1/sqrt(12) of a spacing along each axis
/// times the slope.
struct LookupError {
  double trilinear, nearest;
};
LookupError lookup_error(const FlowGrid& grid, double speed);

}  // namespace clog
