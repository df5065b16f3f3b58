// What the logs of a solved flow case tell: which program, how large the mesh, how well it
// converged.
#pragma once

#include <filesystem>

#include "coupling/files/flow_record.hpp"

namespace clogflow {

/// The record with what the logs and the file `fluxes` tell: version, iterations, residuals, cells, non-orthogonality,
/// and the flux through each surface.
/// \param folder  a flow case that its Allrun has solved
/// \param copies  how many times its mesh fits into the channel
/// \throws Error when a log is missing, or does not hold what it should
FlowRecord read_foam_logs(const std::filesystem::path& folder, double copies, FlowRecord record = {});

/// From the inlet to the outlet of the mesh, over the density [m2/s2]: the file `pressure`.
/// \throws Error when it is missing or holds no number
double read_pressure_drop(const std::filesystem::path& folder);

}  // namespace clogflow
