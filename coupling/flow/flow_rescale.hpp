// One solved flow for several flow rates and fluids of the same channel.
#pragma once

#include "coupling/files/flow_grid.hpp"
#include "coupling/scene/scene.hpp"

namespace clogflow {

/// Reynolds number of the neck: density times mean velocity there times neck width over viscosity
/// [-].
double neck_reynolds_number(const Scene& scene);

/// Largest change of the velocity, over the neck's mean, when the neck's Reynolds number changes by 1.
/// Between creeping flow and 1.18 it was 2.3 % at a half angle of 30, 3.3 % at 60 and 3.4 % at 90
/// degrees, for narrowings from 4 to 1. [-]
inline constexpr double error_per_reynolds_number = 0.034 / 1.18;

/// Up to here that was measured; beyond, a field is not scaled. [-]
inline constexpr double largest_reynolds_number = 1.2;

struct RescaledFlow {
  FlowGrid grid;  ///< as if solved for the scene
  double factor;  ///< on the velocity [-]
  double error;   ///< what the scaling leaves out, over the neck's mean velocity [-]
};

/// The flow scaled to the scene's mean velocity: exact for creeping flow, since its velocity
/// depends neither on the viscosity nor the density. \throws Error when the flow is of another
/// channel or grid, or a Reynolds number is too large
RescaledFlow rescaled_flow(FlowGrid grid, const Scene& scene);

/// Refuses the flow of another scene and names the first value that differs. A flow serves every length of the
/// channel before what was solved (solved_length).
void check_flow_belongs(const Scene& scene, const FlowGrid& flow);

}  // namespace clogflow
