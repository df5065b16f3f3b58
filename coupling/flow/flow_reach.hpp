// How far the neck is felt upstream: beyond, the grid need not cover the channel.
#pragma once

#include <optional>

#include "coupling/files/flow_grid.hpp"
#include "coupling/scene/scene.hpp"

namespace clogflow {

/// Distance upstream of where the channel begins to narrow beyond which the flow is developed to within a
/// tolerance: W / (2 pi) ln(1 / tolerance), not below 0.
///   In a channel no higher than wide a disturbance of the mean over the height dies out at least like its
///   slowest symmetric mode, cos(2 pi y / W) exp(-2 pi |x| / W); its amplitude is taken to be the mean velocity.
/// \param tolerance  largest difference from the duct profile, over the mean velocity of the channel [-], > 0
/// \return [m]
/// \source Hele-Shaw flow is a potential flow; compared with solved fields in tests/pipeline and docs/reports/flow.md
double expected_reach(const Scene& scene, double tolerance);

/// The same distance as the grid has it: upstream of it no point of the fluid differs by more than the
/// tolerance; infinite where the channel's very beginning does. [m]
double measured_reach(const FlowGrid& flow, const Scene& scene, double tolerance);

/// Pressure drop from the inlet of the scene's channel to the outlet of the mesh [Pa]: what was solved, and developed
/// flow in what the scene has before it, whose length the flow does not depend on.
/// \return none where the flow file does not tell what was solved, or the walls are from a file (all is solved)
std::optional<double> channel_pressure_drop(const FlowGrid& flow, const Scene& scene);

}  // namespace clogflow
