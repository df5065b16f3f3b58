#include "dem/protocol/frictionless_flow.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/scene/particle_sizes.hpp"

namespace clogflow {

namespace {

/// Of the strain in the mean flow; and tau that it always has.
constexpr double patience = 10, least_patience = 20;

double solids(const Scene& s, double strain) {
  return strain * s.geometry.neck_width * s.geometry.neck_width * s.geometry.neck_height;
}

}  // namespace

std::int64_t particles_of_strain(const Scene& s, double strain) {
  return std::max<std::int64_t>(1, std::llround(solids(s, strain) / ParticleSizes(s.particles).mean_volume()));
}

double longest_flow(const Scene& s, double strain) {
  const double rate = s.flow_speed() * s.geometry.channel_width * s.geometry.neck_height;
  return patience * solids(s, strain) / rate + least_patience * s.stokes_time();
}

}  // namespace clogflow
