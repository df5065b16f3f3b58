#include "dem/protocol/frictionless_flow.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/geometry/channel_shape.hpp"
#include "coupling/scene/particle_sizes.hpp"
#include "dem/physics/porosity.hpp"

namespace clogflow {

namespace {

/// Of the strain in the mean flow; and tau that it always has.
constexpr double patience = 10, least_patience = 20;

double solids(const Scene& s, double strain) {
  const Geometry& g = s.geometry;
  if (g.neck_area > 0) return strain * g.neck_width * g.neck_area;
  return strain * g.neck_width * g.neck_width * g.neck_height;
}

}  // namespace

std::int64_t particles_of_strain(const Scene& s, double strain) {
  return std::max<std::int64_t>(1, std::llround(solids(s, strain) / ParticleSizes(s.particles).mean_volume()));
}

double longest_flow(const Scene& s, double strain) {
  // What falls has the speed in the neck, what is carried in the channel.
  const double rate =
      s.falls() ? neck_section(s.geometry) * s.speed_scale() : channel_flow_rate(s.geometry, s.flow_speed());
  return patience * solids(s, strain) / rate + least_patience * s.stokes_time();
}

}  // namespace clogflow
