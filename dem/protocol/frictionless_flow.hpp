// A stretch of flow without friction, which makes the column forget how it stood: how much must pass, and how long at
// most.
#pragma once

#include <cstdint>

#include "coupling/scene/scene.hpp"

namespace clogflow {

/// Particles that make up a strain: solids of `strain` neck widths times the neck's cross-section.
///   N = strain D (D H) / (pi d^3 / 6)
/// \return [-]; at least 1
std::int64_t particles_of_strain(const Scene& scene, double strain);

/// When a flow that has not passed its strain is given up: it stands, though nothing rubs. Ten times as long as the
/// fluid takes to carry that much at a packing fraction of one. \return [s]
double longest_flow(const Scene& scene, double strain);

}  // namespace clogflow
