// How far a flow is from the exact one, told by a second solution on a coarser mesh.
#pragma once

#include <filesystem>
#include <optional>

#include "coupling/openfoam/foam_samples.hpp"
#include "coupling/scene/scene.hpp"

namespace clogflow {

/// Velocity error over the mean velocity of the neck [-].
struct VelocityError {
  double rms;      ///< over all sampled points
  double most;     ///< 99 of 100 points are nearer
  double largest;  ///< of all points: next to the neck's edge
};

/// Richardson's estimate of the error of the finer solution, |fine - coarse| / (2^order - 1).
/// \param fine, coarse  samples at the same points
/// \source order 1.5 for rms and 99 %: measured 1.8 to 2.0 for half angles of 30, 60 and 90 degrees
///         and 12 to 48 cells; order 1/2 for the largest: the velocity near the edge of a step goes
///         like distance^0.54 (H. K. Moffatt, J. Fluid Mech. 18 (1964) 1)
VelocityError richardson_error(const FoamSamples& fine, const FoamSamples& coarse, double neck_mean);

/// Richardson's estimate of the relative error of a number such as the pressure drop [-].
double richardson_error(double fine, double coarse);

/// What extrapolation to cells of no size adds to the finer solution:
///   (fine - coarse) / (2^order - 1)
/// \source order 1.8: measured, between that at the neck's edge and the 2 of the schemes
double correction(double fine, double coarse);

/// The error that is told for an extrapolated number: 1.25 times its correction.
/// \source the factor: P. J. Roache, J. Fluids Eng. 116 (1994) 405, for an order known from three
///         meshes or more, as ours is; measured in docs/reports/flow.md
double told_error(double fine, double coarse);

/// Adds the correction to every sample that both solutions have. It stays as it is where only one
/// has it (beside curved walls), and where the correction is more than half of the velocity itself
/// (the coarser mesh does not resolve the flow there).
/// \return the error that is told, of all points
VelocityError extrapolate(FoamSamples& fine, const FoamSamples& coarse, double neck_mean);

/// The coarser solution inside a case.
struct CoarserFlow {
  double cells_per_neck;  ///< [-]
  FoamSamples samples;
  double pressure_drop;  ///< over the density [m2/s2]
};

/// None if the case has none. \throws Error when it must have one (flow.extrapolate), when that is
/// not solved or is of another flow
std::optional<CoarserFlow> read_coarser_flow(const std::filesystem::path& folder, const Scene& scene);

}  // namespace clogflow
