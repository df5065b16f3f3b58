// From the cell that each point of the grid lies in to the velocity there.
#pragma once

#include "coupling/openfoam/foam_cells.hpp"
#include "coupling/openfoam/foam_samples.hpp"

namespace clogflow {

/// The velocities at the points of a lattice by the polynomials of the cells (quadratic_flow.hpp).
/// \param where     at each point the centre of its cell, as sampled by the scheme `cell`
/// \param lattice   in units of the mesh
/// \throws Error where a centre is not one of the cells'
FoamSamples velocities_from_cells(FoamSamples where, const FlowLattice& lattice, const FoamCells& cells);

}  // namespace clogflow
