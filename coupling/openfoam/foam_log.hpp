// What the logs of a solved flow case tell: which program, how large the mesh, how well it
// converged.
#pragma once

#include <filesystem>

#include <nlohmann/json.hpp>

namespace clogflow {

/// Keys openfoam_version, iterations, residuals {Ux, Uy, Uz, p: initial residual of the last
/// iteration}, cells, non_orthogonality [deg], and mass_flux: for each surface of the file `fluxes`
/// its flux [m3/s] through the whole channel and its relative difference from the inlet's.
/// \param folder  a flow case that its Allrun has solved
/// \param copies  how many times its mesh fits into the channel
/// \throws Error when a log is missing, or does not hold what it should
nlohmann::json read_foam_logs(const std::filesystem::path& folder, double copies);

/// From the inlet to the outlet of the mesh, over the density [m2/s2]: the file `pressure`.
/// \throws Error when it is missing or holds no number
double read_pressure_drop(const std::filesystem::path& folder);

}  // namespace clogflow
