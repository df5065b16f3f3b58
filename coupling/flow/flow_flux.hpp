// What a grid carries from the inlet to the outlet, and whether it is the flow that a scene asks for.
#pragma once

#include <vector>

#include "coupling/files/flow_grid.hpp"
#include "coupling/scene/scene.hpp"

namespace clogflow {

/// Volume flux through the plane x = origin + i spacing of the grid by the midpoint rule [m3/s].
double grid_flux(const FlowGrid& grid, int i);

/// Plane i, with what flows through it by grid_flux.
PlaneFlux grid_plane(const FlowGrid& grid, int i, const Scene& scene);

/// Flux of the grid before, along and behind the narrowing, and at `first` [m]; planes beside the grid are left out.
std::vector<PlaneFlux> grid_fluxes(const FlowGrid& grid, const Scene& scene, double first);

/// What one plane may miss of the flow rate of the scene. Interpolation between cells flattens the
/// profile: 0.2 % with 48 cells across the neck, 2 % with 16; where cells are long it wavers by 2 %
/// even with 48. More is a mistake.
inline constexpr double flux_tolerance = 0.1;

/// Refuses a flow that cannot be that of the scene whatever its file says: a grid that does not fill the space between
/// the walls from the narrowing to the outlet, and one that carries nothing, or another rate, or backwards.
/// \throws Error naming the axis or the plane
void check_flow_fits(const FlowGrid& grid, const Scene& scene);

}  // namespace clogflow
