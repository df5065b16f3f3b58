// The flow rate between straight walls, where the cells of the mesh are long.
#pragma once

#include <vector>

#include "coupling/files/flow_grid.hpp"
#include "coupling/scene/scene.hpp"

namespace clogflow {

/// Integral of a function that is known at points one spacing apart and is zero on the walls before
/// the first and behind the last of them. Fourth order: exact for a parabola. \param values   at
/// least two \param before, behind  distance of the wall from the first and from the last point, in
/// spacings, > 0 \return in spacings
double integral_between_walls(const std::vector<double>& values, double before, double behind);

/// Gives every plane before the narrowing, and in the straight part of an expansion, the flow rate
/// of the scene by one factor on its velocity. There the cells are up to half a neck width long,
/// and the interpolation between them, through their centres here and their faces there, wavers
/// along them although the fluxes of the mesh's own faces agree; where cells are short it does not,
/// and nothing is changed, nor is the first plane, which is the series solution.
/// \return the largest relative error of the flow rate that was found
/// \throws Error where that is above flux_tolerance: no matter of interpolation
double restore_flow_rate(FlowGrid& grid, const Scene& scene);

}  // namespace clogflow
