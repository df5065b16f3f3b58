#include "dem/stability/step_limit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "coupling/base/require.hpp"
#include "coupling/geometry/channel_shape.hpp"
#include "coupling/scene/particle_sizes.hpp"
#include "dem/fluid/fluid.hpp"
#include "dem/physics/contact_laws.hpp"
#include "dem/physics/dimensionless.hpp"
#include "dem/physics/lubrication.hpp"
#include "dem/physics/time_step.hpp"
#include "dem/stability/network_limit.hpp"
#include "dem/stability/pack_estimates.hpp"
#include "dem/state/external_force.hpp"
#include "dem/state/initial_particles.hpp"

namespace clogflow {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Of the scene's kinds, or of the particles given.
bool comes_from_scene(const Scene& scene, const std::vector<Particle>& initial) {
  return initial.empty() || scene.inlet.enabled;
}

/// The smallest of every kind, and of the particles given.
std::vector<Particle> smallest_spheres(const Scene& scene, const std::vector<Particle>& initial) {
  const ParticleSizes sizes(scene.particles);
  const double radius = smallest_radius(scene, initial);
  if (sizes.equal() || !comes_from_scene(scene, initial)) return {particle_at_rest(scene, radius)};
  std::vector<Particle> spheres;
  for (std::size_t k = 0; k < sizes.species(); ++k)
    spheres.push_back(particle_at_rest(scene, sizes.of(k).smallest() / 2, sizes.density(k)));
  for (const Particle& p : initial)
    if (p.radius == radius) spheres.push_back(particle_at_rest(scene, radius));
  return spheres;
}

/// What the smallest spheres meet: the largest of the scene, or one like themselves.
Particle largest_neighbour(const Scene& scene, const std::vector<Particle>& initial, const Particle& sphere) {
  const ParticleSizes sizes(scene.particles);
  if (sizes.equal() || !comes_from_scene(scene, initial)) return sphere;
  double density = 0;
  for (std::size_t k = 0; k < sizes.species(); ++k) density = std::max(density, sizes.density(k));
  return particle_at_rest(scene, sizes.largest() / 2, density);
}

double effective_radius(const Particle& a, const Particle& b) { return a.radius * b.radius / (a.radius + b.radius); }

/// 1 / m of two that approach each other: 2 / m of equal ones.
double mobility(const Particle& a, const Particle& b) { return 1 / a.mass + 1 / b.mass; }

bool knows_porosity(const Scene& s) { return s.porosity.strips > 0 || s.porosity.method == PorosityMethod::local; }

double voidage(const Scene& s) { return knows_porosity(s) ? drag_law(s).slow_factor(pack_porosity) : 1.0; }

/// Of the flow between the particles over V0, and of the drag's coefficient the same in a mixture, which keeps V0.
double narrowed(const Scene& s) { return knows_porosity(s) ? 1 / pack_porosity : 1.0; }

bool is_mixture(const Scene& s) { return s.drag.velocity == DragVelocity::mixture; }

/// Weight less buoyancy, along gravity [N]
double external_weight(const Scene& s, const Particle& sphere) {
  const double gravity = Vec3(s.gravity.data()).norm();
  if (!mixes_densities(s)) return sphere.mass * weight_per_mass(s, gravity, s.particles.density);
  const double cube = sphere.radius * sphere.radius * sphere.radius;
  return sphere.mass * gravity / s.time.mass_scale - cube * buoyancy_per_cube(s, gravity);
}

/// Drag of a lone sphere of the Sauter mean, times the squared ratio of sizes: among unequal spheres contacts carry a
/// pressure, so that overlaps over diameters are equal. An assumption, as arch_load is; it holds on average at most:
/// see Caught. [N]
double shared_load(const Scene& s, double d) {
  const double v = s.flow_speed(), mean = ParticleSizes(s.particles).sauter_mean();
  return stokes_coefficient(s.fluid.viscosity, mean) * v * (d / mean) * (d / mean);
}

/// Of one contact of a sphere in a pack [N]
double expected_load(const StepScene& asked, const Particle& sphere) {
  const Scene& s = asked.scene;
  const double d = 2 * sphere.radius, v = asked.factors.load * s.flow_speed();
  const double weight = external_weight(s, sphere);
  double load = arch_load * (Vec3(s.body_force.data()).norm() + std::abs(weight));
  if (s.drag.enabled)
    load += ParticleSizes(s.particles).equal() ? arch_load * voidage(s) * stokes_coefficient(s.fluid.viscosity, d) * v /
                                                     (knows_porosity(s) ? pack_porosity : 1)
                                               : arch_load * voidage(s) * asked.factors.load * shared_load(s, d) /
                                                     (knows_porosity(s) ? pack_porosity : 1);
  return load;
}

double expected_overlap(const StepScene& asked, const Particle& sphere, const std::vector<Particle>& initial) {
  const Scene& s = asked.scene;
  const double d = 2 * sphere.radius;
  double impact = s.falls() ? s.speed_scale() : asked.factors.fastest * collision_speed_share * s.flow_speed();
  for (const Particle& p : initial) impact = std::max(impact, p.velocity().norm());
  return std::max(asked.laws.pair.impact_overlap(sphere.mass / 2, impact, d / 4),
                  asked.laws.pair.overlap_at(expected_load(asked, sphere), d / 4));
}

/// Whether the dry restitution does not matter, as clog plan has it: St of a collision below 10.
bool films_brake(const StepScene& asked, double diameter) {
  const Scene& s = asked.scene;
  const SphereInFluid sphere{diameter, s.particles.density, s.fluid.density, s.fluid.viscosity};
  return s.lubrication.enabled && s.flow_speed() > 0 &&
         collision_stokes_number(sphere, asked.factors.fastest * collision_speed_share * s.flow_speed()) < 10;
}

/// Two equal spheres that meet along their normal.
double impact_limit(const Laws& laws, const Particle& sphere, double overlap) {
  const double mass = sphere.mass / 2;
  const ContactModes modes =
      laws.pair.modes({false, false, false},
                      PairPlace<double>{{1, 0, 0}, sphere.radius, sphere.radius}.contact({1, 0, 0}, overlap, mass));
  return stable_step(modes.mode[0].stiffness / mass, modes.mode[0].dashpot / mass);
}

/// The fastest that the flow or the start makes of any particle [m/s].
double fastest_way(const StepScene& asked, const std::vector<Particle>& initial) {
  const Scene& s = asked.scene;
  double speed = s.falls() ? s.speed_scale() : 0;
  for (const Particle& p : initial) speed = std::max(speed, p.velocity().norm());
  if (!s.drag.enabled) return speed;
  const double f = is_mixture(s) ? 1 : narrowed(s);
  const bool channel = s.geometry.present && s.flow.mean_velocity > 0;
  return std::max(speed, asked.factors.fastest * f *
                             (channel ? neck_mean_velocity(s.geometry, s.flow.mean_velocity) : s.flow_speed()));
}

/// A sphere between two walls' worth of contacts: one wall and five neighbours along the axes, the densest
/// load that a pack offers; all at the same overlap.
double pack_limit(const StepScene& asked, const Particle& sphere, const Particle& neighbour, double overlap) {
  Particles p;
  p.add(sphere);
  for (int k = 0; k < 5; ++k) p.add(neighbour);
  const bool equal = sphere.radius == neighbour.radius && sphere.mass == neighbour.mass;
  const double mass = equal ? sphere.mass / 2 : 1 / mobility(sphere, neighbour);
  NetworkLimit network(p);
  const double r = sphere.radius;
  const Vec3 axes[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
  for (int k = 0; k < 5; ++k)
    network.add_contact(
        0, k + 1,
        asked.laws.pair.modes(asked.laws.pair_terms,
                              PairPlace<double>{axes[k], r, neighbour.radius}.contact(axes[k], overlap, mass)));
  if (asked.has_walls)
    network.add_contact(
        0, -1, asked.laws.wall.contact.modes(asked.laws.wall.terms, wall_contact({0, 0, -1}, overlap, r, sphere.mass)));
  return network.bound().step;
}

/// A small sphere that two large ones have caught between them bears what they bear: seen in packs of 40 um with 10 and
/// 4 um (docs/sizes.md), where its overlaps were up to nine times those that a pressure gives.
struct Caught {
  double overlap, step;  ///< with each [m], largest stable [s]
};

Caught caught_between(const StepScene& asked, const Particle& sphere, const Particle& neighbour) {
  const double overlap =
      asked.laws.pair.overlap_at(expected_load(asked, neighbour), effective_radius(sphere, neighbour));
  Particles p;
  p.add(sphere);
  for (int k = 0; k < 2; ++k) p.add(neighbour);
  NetworkLimit network(p);
  for (const int k : {1, 2}) {
    const Vec3 axis{k == 1 ? 1.0 : -1.0, 0, 0};
    network.add_contact(
        0, k,
        asked.laws.pair.modes(asked.laws.pair_terms, PairPlace<double>{axis, sphere.radius, neighbour.radius}.contact(
                                                         axis, overlap, 1 / mobility(sphere, neighbour))));
  }
  return {overlap, network.bound().step};
}

}  // namespace

double smallest_radius(const Scene& scene, const std::vector<Particle>& initial) {
  double radius = comes_from_scene(scene, initial) ? ParticleSizes(scene.particles).smallest() / 2 : infinite;
  for (const Particle& p : initial) radius = std::min(radius, p.radius);
  return radius;
}

double StepLimits::smallest() const { return std::min({drag, lubrication, contacts}); }

namespace {

StepLimits limits_of(const StepScene& asked, const Particle& sphere, const std::vector<Particle>& initial) {
  const Scene& s = asked.scene;
  const Particle neighbour = largest_neighbour(s, initial, sphere);
  const bool equal = ParticleSizes(s.particles).equal();
  const double d = 2 * sphere.radius;
  const double shear = s.contact.youngs_modulus / (2 * (1 + s.contact.poisson_ratio));
  StepLimits limits;
  limits.contact_time = asked.contact_time;
  limits.linear = !contact_traits(s.contact.law).knows_modulus;
  if (!limits.linear)
    limits.rayleigh_time =
        rayleigh_time(sphere.radius, s.particles.density * s.time.mass_scale, shear, s.contact.poisson_ratio);
  limits.drag = limits.lubrication = limits.contacts = infinite;
  limits.passing = d / fastest_way(asked, initial);
  if (s.drag.enabled && s.time.integrator == Integrator::verlet)
    limits.drag = stable_step(
        0, (is_mixture(s) ? narrowed(s) : 1) * voidage(s) * stokes_coefficient(s.fluid.viscosity, d) / sphere.mass);
  if (asked.laws.film.viscosity > 0 && s.time.integrator != Integrator::implicit_fluid) {
    const auto& film = asked.laws.film;
    limits.lubrication =
        equal ? stable_step(0, 2 * lubrication_coefficient(film.viscosity, d / 4, film.nearest) / sphere.mass)
              : stable_step(
                    0, mobility(sphere, neighbour) *
                           lubrication_coefficient(film.viscosity, effective_radius(sphere, neighbour), film.nearest));
    if (asked.laws.wall.lubrication.viscosity > 0)
      limits.lubrication =
          std::min(limits.lubrication,
                   stable_step(0, lubrication_coefficient(film.viscosity, d / 2, film.nearest) / sphere.mass));
  }
  const double overlap = expected_overlap(asked, sphere, initial);
  limits.expected_overlap = overlap / d;
  if (overlap > 0) {
    limits.contacts = pack_limit(asked, sphere, sphere, overlap);
    if (!equal) {
      const Caught caught = caught_between(asked, sphere, neighbour);
      limits.expected_overlap = std::max(limits.expected_overlap, caught.overlap / d);
      limits.contacts = std::min({limits.contacts, pack_limit(asked, sphere, neighbour, overlap),
                                  caught.overlap > 0 ? caught.step : infinite});
    }
    limits.impact = impact_limit(asked.laws, sphere, overlap);
  }
  limits.films_brake = films_brake(asked, d);
  return limits;
}

}  // namespace

StepLimits expected_limits(const StepScene& asked, const std::vector<Particle>& initial) {
  StepLimits all;
  bool first = true;
  for (const Particle& sphere : smallest_spheres(asked.scene, initial)) {
    const StepLimits own = limits_of(asked, sphere, initial);
    if (first) {
      all = own;
      first = false;
      continue;
    }
    for (auto limit : {&StepLimits::rayleigh_time, &StepLimits::drag, &StepLimits::lubrication, &StepLimits::contacts,
                       &StepLimits::impact, &StepLimits::passing})
      all.*limit = std::min(all.*limit, own.*limit);
    all.expected_overlap = std::max(all.expected_overlap, own.expected_overlap);
    all.films_brake = all.films_brake && own.films_brake;
  }
  return all;
}

std::string limit_words(const StepLimits& l, double dt) {
  std::string line = fmt::format("dt = {:.3g} s", dt);
  const auto ratio = [&](const char* name, double limit) {
    if (limit > 0) line += fmt::format(", dt/{} {:.2g}", name, dt / limit);
  };
  ratio(l.linear ? "contact time" : "tau_Hertz", l.contact_time);
  ratio("Rayleigh", l.rayleigh_time);
  ratio("drag limit", l.drag);
  ratio("lubrication limit", l.lubrication);
  ratio("contact limit", l.contacts);
  return line;
}

std::string overlap_warning(const StepLimits& l, const Scene::Contact& contact) {
  if (l.expected_overlap <= deepest_overlap) return {};
  return fmt::format(
      "overlaps of {:.2g} diameters are to be expected (no more than {} means anything): {} or slow the flow",
      l.expected_overlap, deepest_overlap, overlap_remedy(contact, ", "));
}

std::string passing_warning(const StepLimits& l, double dt) {
  const double share = dt / l.passing;
  if (share <= long_share) return {};
  return fmt::format(
      "in a step of {:.3g} s the fastest particles go {:.2g} of a diameter (more than {}: contacts are met late; a "
      "run refuses more than {})",
      dt, share, long_share, longest_share);
}

double impact_error(const StepLimits& l, double dt) { return 0.36 * dt * dt / (l.impact * l.impact); }

std::string impact_warning(const StepLimits& l, double dt) {
  const double error = impact_error(l, dt);
  if (error <= 0.01 || l.films_brake) return {};
  return fmt::format(
      "the step is {:.2g} of the limit of two spheres that collide: the restitution of single impacts is off by up to "
      "{:.2g} %, on average by less than one",
      dt / l.impact, 100 * error);
}

std::string check_step(const StepLimits& l, const StepChoice& step) {
  require(step.dt <= longest_share * l.passing,
          "in a step of {:.3g} s the fastest particles go {:.2g} of a diameter (no more than {}, or contacts are met "
          "too late): lower {}",
          step.dt, step.dt / l.passing, longest_share, step.key);
  const std::string deep = overlap_warning(l, step.contact);
  require(deep.empty(), "{}", deep);
  const double limit = l.smallest(), dt = step.dt;
  const char* force = limit == l.drag ? "drag" : limit == l.lubrication ? "lubrication" : "the contacts";
  const char* key = step.key;
  const std::string remedy =
      limit == l.drag ? fmt::format("set time.integrator = \"implicit_drag\", lower {} or raise time.mass_scale", key)
      : limit == l.lubrication
          ? fmt::format(
                "set time.integrator = \"implicit_fluid\", lower {}, raise time.mass_scale or particles.roughness", key)
          : fmt::format("lower {} or {}", key, stiffness_key(step.contact));
  if (dt > limit) {
    const std::string what = fmt::format("the step of {:.3g} s is unstable: {} allow{} {:.3g} s; {}", dt, force,
                                         limit == l.contacts ? "" : "s", limit, remedy);
    require(step.allow_unstable, "{}", what);
    return what;
  }
  if (dt <= near_limit * limit) return {};
  return fmt::format("the step of {:.3g} s is near the limit of {}, {:.3g} s: {}", dt, force, limit, remedy);
}

}  // namespace clogflow
