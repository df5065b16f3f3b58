// Weight less buoyancy: fall in vacuum, Stokes' settling velocity, of spheres heavier and lighter than the fluid.
#include "tests/dem/laboratory.hpp"
#include "tests/verification/check.hpp"

namespace clogflow::verification {

using test::Laboratory;
using test::laboratory_scene;

namespace {

constexpr double g = 9.81, eta = 1.8e-3, rho_f = 1062;

double stokes_velocity(double density, double diameter) {
  return (density - rho_f) * g * diameter * diameter / (18 * eta);
}

/// Two sizes at once: 33 and 66 um, far apart, each to its own velocity.
void add_settling(Group& group, double density, Integrator integrator, double mass_scale, const std::string& name) {
  const double d = 33e-6, response = mass_scale * density * d * d / (18 * eta);
  Scene s = laboratory_scene({3e6, 0.35, density, d}, response / 200);
  s.fluid.viscosity = eta, s.fluid.density = rho_f;
  s.gravity = {0, 0, -g};
  s.drag.enabled = true;
  s.flow.source = FlowSource::uniform;
  s.time.integrator = integrator, s.time.mass_scale = mass_scale;
  Laboratory lab(s, {{.radius = d / 2}, {.radius = d, .x = 1e-2}});
  lab.run_until(160 * response);
  for (const int i : {0, 1})
    group.checks.push_back({fmt::format("{}, {} um [m/s]", name, i ? 66 : 33), -stokes_velocity(density, i ? 2 * d : d),
                            lab.velocity(i).z, 1e-6});
}

}  // namespace

Group gravity() {
  Group group{
      "Gravity and buoyancy",
      "Free fall g t^2 / 2 without a fluid, and Stokes' settling velocity (rho_p - rho_f) g d^2 / (18 eta): spheres of "
      "33 "
      "and 66 um in one run, heavier (1200 kg/m3) and lighter (950 kg/m3) than the paper's fluid, explicit, implicit "
      "and with scaled mass, on which it does not depend. Limits: 1e-9 for the fall, which the integrator has "
      "exactly; 1e-6 for the final state.",
      {}};
  Scene s = laboratory_scene({3e6, 0.35, 1200, 2e-3}, 1e-4);
  s.gravity = {g * 0.6, 0, -g * 0.8};
  Laboratory lab(s, {{.radius = 1e-3}});
  lab.run_until(0.1);
  group.checks.push_back(
      {"fall in 0.1 s, along the slope of gravity [m]", 0.5 * g * 0.01, lab.position(0).norm(), 1e-9});
  group.checks.push_back({"its direction, x / z", -0.75, lab.position(0).x / lab.position(0).z, 1e-12});
  add_settling(group, 1200, Integrator::verlet, 1, "heavier, explicit");
  add_settling(group, 1200, Integrator::implicit_drag, 1, "heavier, implicit");
  add_settling(group, 1200, Integrator::verlet, 30, "heavier, mass x 30");
  add_settling(group, 950, Integrator::verlet, 1, "lighter, explicit");
  return group;
}

}  // namespace clogflow::verification
