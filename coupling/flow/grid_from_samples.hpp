// From the sampled part of the lattice to a grid of the whole channel.
#pragma once

#include "coupling/files/flow_grid.hpp"
#include "coupling/openfoam/flow_space.hpp"
#include "coupling/openfoam/foam_samples.hpp"
#include "coupling/scene/scene.hpp"

namespace clogflow {

/// Velocity and solid mask alone: points, origin, spacing, velocity, solid.
/// \throws Error when a point in the fluid has no sample
FlowGrid grid_from_samples(const Scene& scene, const FlowLattice& lattice, const FoamSamples& samples);

/// The same for a channel from a file, where all is sampled; points beside curved walls that the mesh
/// does not reach are solid. \throws Error when they are too many
FlowGrid stl_grid_from_samples(const Scene& scene, const FlowSpace& space, const FoamSamples& samples);

}  // namespace clogflow
