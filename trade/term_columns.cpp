#include "trade/term_columns.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "coupling/flow/channel_drop.hpp"
#include "coupling/geometry/channel_geometry.hpp"
#include "coupling/geometry/channel_shape.hpp"
#include "dem/physics/dimensionless.hpp"
#include "dem/physics/drag.hpp"
#include "dem/physics/drag_law.hpp"
#include "trade/spread.hpp"

namespace clogflow {

namespace {

constexpr double liquid_density = 1062, heavier = 2;                          // [kg/m3], [-]
constexpr double channel_width = 3.2, neck_width = 0.8, channel_length = 10;  // [d]

/// Rounded for a scene's text, as every quantity there.
Scene channel_scene(const ExtremePoint& p) {
  const double d = p.diameter;
  // The diameter is set afterwards: a neck that no sphere passes is refused, and is what holds this column.
  const std::string channel =
      fmt::format(R"(
[geometry]
neck_width = "{} m"
neck_height = "{} m"
channel_width = "{} m"
channel_length = "{} m"
half_angle = "90 deg"
neck_length = "{} m"
[flow]
source = "openfoam"
mean_velocity = "{} m/s"
extrapolate = false
[drag]
velocity = "mixture"
[porosity]
method = "local"
width = "{} m"
)",
                  neck_width * d, channel_width * d, channel_width * d, channel_length * d, 2 * d, p.velocity, 1.5 * d);
  return parse_scene(channel + spheres_in_liquid(p, 0.5 * d), "extremes");
}

/// What a scene of a box has too.
void set_common(const ExtremePoint& p, Scene& s) {
  s.particles.diameter = p.diameter;
  s.particles.roughness = 0.005 * p.diameter;
  s.contact.restitution = s.contact.wall_restitution = p.restitution;
  s.contact.friction = s.contact.wall_friction = {p.friction, p.friction, p.friction};
  s.lubrication.enabled = p.films;
  s.lubrication.cutoff = p.diameter / 2;
  s.time.step_fraction = p.step_fraction;
  s.time.integrator = p.integrator;
}

void set_kinds(const TermPoint& p, Scene& s) {
  if (p.size_ratio == 1 && p.density_ratio == 1 && p.friction_share == 1) return;
  const double d = p.base.diameter, mu = p.base.friction, less = p.friction_share * mu;
  Species large{.diameter = d, .share = 0.5, .density = s.particles.density}, small = large;
  small.diameter /= p.size_ratio, small.density *= p.density_ratio;
  if (p.friction_share != 1) {
    large.friction = large.wall_friction = {mu, mu, mu};
    small.friction = small.wall_friction = {less, less, less};
  }
  s.particles.species = {large, small};
  s.particles.diameter = (large.diameter + small.diameter) / 2;
  s.particles.roughness = 0.005 * small.diameter;
  s.lubrication.cutoff = s.particles.diameter / 2;
}

void set_law(const TermPoint& p, Scene& s) {
  const double d = p.base.diameter;
  s.contact.law = p.law;
  if (p.law == "hooke") {
    s.contact.stiffness = p.spring * p.base.youngs_modulus * d;
    s.contact.tangential_factor = 2.0 / 7;
  }
  const double per_radius = std::numbers::pi * (p.law == "jkr" ? 1.5 : 2);
  if (p.stickiness > 0) s.contact.surface_energy = p.stickiness * drag_of_one(p.base, s) / (per_radius * d / 4);
  if (p.mercury) s.contact.turning = "mercury";
}

void set_loads(const TermPoint& p, Scene& s) {
  s.drag.law = p.drag;
  if (p.weight > 0) {
    const double cube = std::pow(p.base.diameter, 3);
    const double mass = (s.particles.density - liquid_density) * std::numbers::pi / 6 * cube;
    s.gravity = {0, 0, -p.weight * drag_of_one(p.base, s) / mass};
  }
}

/// How far a sphere at the middle of the wall sinks into the neck's slot until it touches the nearer edge.
double depth_in_neck(double d, double across) {
  const double edge = neck_width / 2 * d - std::abs(across);
  return d / 2 - std::sqrt(d * d / 4 - edge * edge);
}

void set_balance(const TermPoint& p, Scene& s) {
  const double drop = *estimated_pressure_drop(s);
  if (p.term == Term::pressure) {
    s.flow.drive = DrivenBy::pressure;
    s.flow.pressure_drop = p.drop_ratio * drop;
  } else {
    const double rate = s.flow.mean_velocity * s.geometry.channel_width * s.geometry.neck_height;
    const double step = p.base.step_fraction * make_model(s, nullptr, {}).contact_time;
    s.flow.compliance = p.compliance_steps * step * rate / drop;
  }
}

void set_walls(const TermPoint& p, Scene& s) {
  s.contact.wall_youngs_modulus = p.wall_ratio * p.base.youngs_modulus;
  if (p.term != Term::walls) return;
  s.lubrication.walls = p.base.films;
  s.drag.viscous_torque = p.base.number % 3 != 0;
}

}  // namespace

bool in_channel(Term term) { return term == Term::local || term == Term::pressure || term == Term::compliance; }

double drag_of_one(const ExtremePoint& base, const Scene& s) {
  return stokes_coefficient(base.viscosity, base.diameter) * s.flow_speed();
}

Scene term_scene(const TermPoint& p) {
  const bool channel = in_channel(p.term);
  Scene s = channel ? channel_scene(p.base) : extreme_scene(p.base, 0);
  set_common(p.base, s);
  if (p.weight > 0) s.particles.density = heavier * liquid_density;
  set_kinds(p, s);
  set_law(p, s);
  set_loads(p, s);
  set_walls(p, s);
  if (p.term == Term::pressure || p.term == Term::compliance) set_balance(p, s);
  return s;
}

std::shared_ptr<FlowGrid> term_flow(const Scene& s) {
  if (!s.geometry.present) return nullptr;
  const auto& g = s.geometry;
  auto grid = std::make_shared<FlowGrid>();
  grid->scene_text = effective_scene(s);
  grid->hash = content_hash(flow_inputs(s));
  const int across = 16;
  const double h = g.neck_height / across, start = channel_start(g);
  grid->spacing = h;
  grid->origin = Vec3(start + h / 2, -g.channel_width / 2 + h / 2, h / 2);
  grid->points = {static_cast<int>(std::lround((g.neck_length - start) / h)), across, across};
  const std::size_t count = static_cast<std::size_t>(grid->points[0]) * across * across;
  grid->velocity.assign(3 * count, 0.0f);
  grid->solid.assign(count, 0);
  grid->walls = channel_walls(g);
  for (int k = 0; k < across; ++k)
    for (int j = 0; j < across; ++j)
      for (int i = 0; i < grid->points[0]; ++i) {
        const double width = channel_shape(g).width(grid->origin.x + i * h), y = grid->origin.y + j * h;
        const std::size_t at = grid->index(i, j, k);
        if (std::abs(y) < width / 2)
          grid->velocity[3 * at] = static_cast<float>(s.flow.mean_velocity * g.channel_width / width);
        else
          grid->solid[at] = 1;
      }
  grid->record.pressure_drop = estimated_pressure_drop(s);
  return grid;
}

std::vector<Particle> term_particles(const TermPoint& p, double overlap) {
  const double d = p.base.diameter, smallest = d / p.size_ratio;
  const double spin = 10 * overlap * std::sqrt(p.base.youngs_modulus / liquid_density) / d;
  const bool channel = in_channel(p.term), kinds = p.size_ratio != 1 || p.density_ratio != 1 || p.friction_share != 1;
  std::vector<Particle> particles;
  double top[9];
  for (int stack = 0; stack < 9; ++stack) top[stack] = 0;
  for (int k = 0; k < p.base.particles; ++k) {
    const auto off = [&](int base) { return halton(k + 1, base) - 0.5; };
    const int stack = k % 9, layer = k / 9;
    const bool is_small = kinds && (stack + layer) % 2 == 1;
    Particle s;
    s.species = is_small;
    s.radius = (is_small ? smallest : d) / 2;
    // Neighbours of one layer do not touch.
    const double shift = 0.02 * smallest, pitch = 1.03 * d;
    const double across = (stack % 3 - 1) * pitch + shift * off(2), along = (stack / 3 - 1) * pitch + shift * off(3);
    const double dip = channel && stack % 3 == 1 && layer == 0 ? depth_in_neck(d, across) : 0;
    const double height = top[stack] + s.radius - overlap * smallest - dip;
    top[stack] = height + s.radius;
    s.wx = 0.02 * spin * off(5), s.wy = 0.02 * spin * off(7), s.wz = 0.02 * spin * off(11);
    if (channel)
      s.x = -height, s.y = across, s.z = channel_width / 2 * d + along;
    else
      s.x = across, s.y = along, s.z = height;
    particles.push_back(s);
  }
  return particles;
}

}  // namespace clogflow
