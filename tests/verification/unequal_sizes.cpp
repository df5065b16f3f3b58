// Unequal spheres: their drag in a pack, the weight of two densities, and what an inlet brings in.
#include <numbers>

#include "dem/run/inlet.hpp"
#include "tests/dem/channel_scene.hpp"
#include "tests/verification/check.hpp"

namespace clogflow::verification {

using test::laboratory_scene;

namespace {

constexpr double g = 9.81, eta = 1.8e-3, rho_f = 1062;

/// Drag on a bed of half 20 and half 40 um spheres by number at rest, over that of the same number of spheres of the
/// Sauter mean 36 um by the law of equal spheres.
void add_drag(Group& group) {
  Scene s = laboratory_scene({3e6, 0.35, rho_f, 30e-6}, 1e-6);
  s.fluid.viscosity = eta, s.fluid.density = rho_f;
  s.drag.enabled = true;
  s.particles.species = {{20e-6, 0.5, 0}, {40e-6, 0.5, 0}};
  const double volume = std::numbers::pi / 6 * (std::pow(20e-6, 3) + std::pow(40e-6, 3));
  const auto force = [&](double porosity, int particle) {
    Fluid fluid(s, FlowField(std::array<double, 3>{1e-3, 0, 0}),
                PorosityStrips(-1e-3, 1e-3, {volume / (1 - porosity)}));
    Particles p;
    p.add({.radius = 10e-6, .x = -1e-4});
    p.add({.radius = 20e-6, .x = 1e-4});
    fluid.update_porosity(p);
    fluid.evaluate(p);
    return fluid.drag_force(particle, {0, 0, 0}).x;
  };
  for (const double eps : {0.4, 0.6}) {
    const double f = find_drag_law("hoef").slow_factor(eps);
    for (const int i : {0, 1}) {
      const double d = i ? 40e-6 : 20e-6, y = d / 36e-6;
      const double wanted =
          (eps * y + (1 - eps) * y * y + 0.064 * eps * y * y * y) * f * 3 * std::numbers::pi * eta * d * 1e-3 / eps;
      group.checks.push_back({fmt::format("drag on {} um of 20 and 40 um at porosity {} [N]", i ? 40 : 20, eps), wanted,
                              force(eps, i), 1e-12});
    }
  }
}

/// Two kinds at once, one sinks and one rises.
void add_settling(Group& group) {
  const double d = 33e-6, density[] = {1200, 950}, response = 1200 * 4 * d * d / (18 * eta);
  Scene s = laboratory_scene({3e6, 0.35, rho_f, 1.5 * d}, response / 400);
  s.fluid.viscosity = eta, s.fluid.density = rho_f;
  s.gravity = {0, 0, -g};
  s.drag.enabled = true;
  s.flow.source = FlowSource::uniform;
  s.particles.species = {{d, 0.5, density[0]}, {2 * d, 0.5, density[1]}};
  Particle small{.radius = d / 2}, large{.radius = d, .x = 1e-2};
  large.species = 1;
  Simulation run(s, nullptr, 1, {small, large});
  while (run.time() < 80 * response) {
    run.compute_forces();
    run.advance();
  }
  for (const int i : {0, 1}) {
    const double size = i ? 2 * d : d;
    const auto& states = run.particles().states;
    const double speed = states[states[0].radius == size / 2 ? 0 : 1].vz;
    group.checks.push_back({fmt::format("{} kg/m3 of {} um, both in one run [m/s]", density[i], 1e6 * size),
                            -(density[i] - rho_f) * g * size * size / (18 * eta), speed, 1e-6});
  }
}

/// Of all that comes in, while what is there is carried on.
void add_feed(Group& group, const std::string& kind) {
  const Scene s = test::short_channel_scene(
      {"particles.size_distribution=" + kind, "particles.size_spread=0.1", "geometry.channel_length=300 um"});
  const FlowGrid grid = test::synthetic_flow(s);
  const Model model = make_model(s, &grid, {});
  const Fluid fluid = make_fluid(s, &grid);
  Inlet inlet(model);
  RandomStream random(11);
  Particles p;
  double sum = 0, squares = 0;
  constexpr int count = 10000;
  for (std::int64_t seen = 0; seen < count;) {
    inlet.insert(p, fluid, random, 0);
    std::vector<int> staying;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double d = 2 * p[i].radius / 33e-6;
      if (p.id[i] >= seen && p.id[i] < count) sum += d, squares += d * d;
      p[i].x += 1e-6;
      if (p[i].x < 0) staying.push_back(static_cast<int>(i));
    }
    seen = inlet.inserted();
    p.reorder(staying);
  }
  const double mean = sum / count, spread = std::sqrt(squares / count - mean * mean) / mean;
  group.checks.push_back({kind + ": mean over that asked for", 1, mean, 4e-3});
  group.checks.push_back({kind + ": standard deviation over mean", 0.1, spread, 4e-2});
}

}  // namespace

Group unequal_sizes() {
  Group group{
      "Unequal sizes",
      "The drag of van der Hoef, Beetstra & Kuipers (2005) on each size of a bidisperse bed, <d> = 36 um of 20 and 40 "
      "um in equal numbers; Stokes' settling velocity of two densities in one run, of which one rises; and the first "
      "10,000 particles that came into a crowded slab against the distribution asked for. Limits: 1e-12 for the "
      "formula, 1e-6 for the final state, four standard errors for the feed.",
      {}};
  add_drag(group);
  add_settling(group);
  for (const char* kind : {"uniform", "normal", "lognormal"}) add_feed(group, kind);
  return group;
}

}  // namespace clogflow::verification
