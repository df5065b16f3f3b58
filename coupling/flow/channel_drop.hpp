// The pressure that drives the flow through the channel of a scene, without particles.
#pragma once

#include <optional>

#include "coupling/files/flow_grid.hpp"
#include "coupling/scene/scene.hpp"

namespace clogflow {

/// From the inlet of the scene's channel to the outlet, as it was solved (channel_pressure_drop; all of it between the
/// walls of a file) [Pa]
/// \throws Error if the flow file does not tell it
double solved_pressure_drop(const FlowGrid& flow, const Scene& scene);

/// The same without a flow file: developed flow in ducts of the channel's width at each x. Neglects what turning into
/// the neck costs. \return none between the walls of a file [Pa]
std::optional<double> estimated_pressure_drop(const Scene& scene);

}  // namespace clogflow
