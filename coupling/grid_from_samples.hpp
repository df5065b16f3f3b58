// From the sampled part of the lattice to a grid of the whole channel.
#pragma once

#include "coupling/flow_grid.hpp"
#include "coupling/flow_space.hpp"
#include "coupling/foam_samples.hpp"
#include "coupling/scene.hpp"

namespace clog {

/// Velocity and solid mask alone: points, origin, spacing, velocity, solid.
/// \throws Error when a point in the fluid has no sample
FlowGrid grid_from_samples(const Scene& scene, const FlowLattice& lattice,
                           const FoamSamples& samples);

/// The same for a channel from a file, where all is sampled; points beside curved walls that the mesh
/// does not reach are solid. \throws Error when they are too many
FlowGrid stl_grid_from_samples(const Scene& scene, const FlowSpace& space, const FoamSamples& samples);

}  // namespace clog
