// Textbook motions of one or two spheres: friction on a floor, drag, the film between spheres, and the
// same laws from a micrometre to a metre.
#include "tests/dem/laboratory.hpp"
#include "tests/verification/check.hpp"

namespace clogflow::verification {

using test::Laboratory;
using test::laboratory_scene;

namespace {

/// A sphere on a floor that carries a load, at a size of choice. Everything scales with the radius:
/// E so large that the overlap is 1e-4 r, speeds of 10 r per slip time.
struct Floor {
  double radius, density, load, modulus;

  double mass() const { return density * 4.0 / 3 * M_PI * std::pow(radius, 3); }
  double effective() const { return modulus / (2 * (1 - 0.3 * 0.3)); }
  double overlap() const { return std::pow(3 * load / (4 * effective() * std::sqrt(radius)), 2.0 / 3); }
  double period() const { return 2 * M_PI * std::sqrt(mass() * overlap() / (1.5 * load)); }

  Scene scene(const Friction& friction, double slope = 0) const {
    Scene s = laboratory_scene({modulus, 0.3, density, 2 * radius}, period() / 100);
    test::set_floor(s, 1e4 * radius);
    test::set_friction(s, friction);
    s.contact.restitution = 0.3;
    s.body_force = {load * std::sin(slope), 0, -load * std::cos(slope)};
    return s;
  }

  Particle resting(double slope = 0) const {
    return {.radius = radius, .z = radius - overlap() * std::pow(std::cos(slope), 2.0 / 3)};
  }
};

/// Load that gives the overlap 1e-4 r.
Floor floor_of(double radius, double density, double modulus) {
  const double effective = modulus / (2 * (1 - 0.3 * 0.3));
  return {radius, density, 4.0 / 3 * effective * radius * radius * 1e-6, modulus};
}

/// The lever is r - delta / 2 and the springs have a length: both of the order of the overlap, 1e-4.
constexpr double to_the_overlap = 2e-3;

void add_floor_checks(Group& group, const Floor& floor, const std::string& name) {
  const double mu = 0.2, r = floor.radius, mass = floor.mass(), inertia = 0.4 * mass * r * r;
  const double u0 = 2000 * mu * floor.load / mass * floor.period();  // slips for 570 periods
  {
    const double end = 2.0 / 7 * u0 * mass / (mu * floor.load);
    Particle sphere = floor.resting();
    sphere.vx = u0;
    Laboratory lab(floor.scene({.sliding = mu}), {sphere});
    lab.run_until(end / 2);
    const double t = lab->time() - lab->model().dt / 2;  // velocities stand half a step before
    group.checks.push_back({name + ": velocity while slipping / u0", 1 - mu * floor.load / mass * t / u0,
                            lab.velocity(0).x / u0, to_the_overlap});
    group.checks.push_back({name + ": spin while slipping r w / u0", mu * floor.load * r / inertia * t * r / u0,
                            lab.spin(0).y * r / u0, to_the_overlap});
    lab.run_until(1.5 * end);
    group.checks.push_back(
        {name + ": velocity when slip has ceased / u0", 5.0 / 7, lab.velocity(0).x / u0, to_the_overlap});
    group.checks.push_back(
        {name + ": spin when slip has ceased r w / u0", 5.0 / 7, lab.spin(0).y * r / u0, to_the_overlap});
  }
  {
    Particle sphere = floor.resting();
    sphere.wy = u0 / r;
    Laboratory lab(floor.scene({.rolling = mu}), {sphere});
    lab.run_until(0.5 * sphere.wy * inertia / (mu * r * floor.load));
    const double t = lab->time() - lab->model().dt / 2;
    group.checks.push_back({name + ": rolling decay w / w0 = 1 - 5 mu F t / (2 m r w0)",
                            1 - mu * r * floor.load / inertia * t / sphere.wy, lab.spin(0).y / sphere.wy,
                            to_the_overlap});
  }
  {
    Particle sphere = floor.resting();
    sphere.wz = u0 / r;
    Laboratory lab(floor.scene({.torsion = mu}), {sphere});
    lab.run_until(0.5 * sphere.wz * inertia / (2 * mu * r * floor.load));
    const double t = lab->time() - lab->model().dt / 2;
    group.checks.push_back({name + ": twist decay w / w0 = 1 - 5 mu F t / (m r w0)",
                            1 - 2 * mu * r * floor.load / inertia * t / sphere.wz, lab.spin(0).z / sphere.wz,
                            to_the_overlap});
  }
  {
    const double slope = 0.3, duration = 500 * floor.period();
    Laboratory lab(floor.scene({.sliding = 0.5}, slope), {floor.resting(slope)});
    lab.run_until(duration);
    const double t = lab->time() - lab->model().dt / 2, fall = floor.load * std::sin(slope) / mass * t;
    group.checks.push_back({name + ": incline, v = 5/7 g sin t", 5.0 / 7, lab.velocity(0).x / fall, 5e-3});
  }
}

}  // namespace

Group sliding_and_rolling() {
  Group group{"Friction on a floor",
              "Gross sliding, slip cessation at 5/7 u0, decay of rolling and twist, rolling down a slope; closed forms "
              "as in LAMMPS' examples. "
              "Limit: the lever r - delta/2 and the length of the springs, of the order of the overlap (1e-4 r), and "
              "100 steps a contact period.",
              {}};
  add_floor_checks(group, floor_of(0.01, 2500, 1e8), "1 cm");
  {
    // Spinning without friction: nothing changes.
    const Floor floor = floor_of(0.01, 2500, 1e8);
    Particle sphere = floor.resting();
    sphere.vx = 0.1, sphere.wy = 3, sphere.wz = 5;
    Laboratory lab(floor.scene({}), {sphere});
    for (int k = 0; k < 5000; ++k) lab.step();
    group.checks.push_back({"no friction: velocity", 0.1, lab.velocity(0).x, 0});
    group.checks.push_back({"no friction: spin", 5, lab.spin(0).z, 0});
  }
  return group;
}

Group sizes() {
  Group group{"The same laws at any size",
              "Friction on a floor for spheres of 1 um, 33 um and 1 m: springs of 1e-12 m and of 1e-5 m obey the same "
              "law, for nothing in it has a length of its own.",
              {}};
  add_floor_checks(group, floor_of(0.5e-6, 1062, 3e6), "1 um");
  add_floor_checks(group, floor_of(16.5e-6, 1062, 3e6), "33 um");
  add_floor_checks(group, floor_of(0.5, 2500, 1e9), "1 m");
  return group;
}

namespace {

/// Inertia gone, m dv/dt = 0 = F - a v / h: h = h0 exp(-F t / a), a = 6 pi eta r^2. In 200 steps to h0 / e.
Check pressed_film(Scene s) {
  const double r = s.particles.diameter / 2, h0 = 4e-6, force = 2e-11, a = 6 * M_PI * s.fluid.viscosity * r * r;
  s.time.step = a / force / 200;
  s.time.integrator = Integrator::implicit_fluid;
  s.lubrication.enabled = s.lubrication.walls = true;
  s.lubrication.cutoff = r;
  s.body_force = {0, 0, -force};
  test::set_floor(s, 200 * r);
  Laboratory lab(s, {{.radius = r, .z = r + h0, .vz = -force * h0 / a}});
  for (int k = 0; k < 200; ++k) lab.step();
  return {"implicit film under a pressed sphere: gap / first gap", std::exp(-1.0), (lab.position(0).z - r) / h0, 1e-2};
}

}  // namespace

Group fluid_closed_forms() {
  constexpr double eta = 1.8e-3, d = 33e-6, rho = 1062;
  const double mass = rho * M_PI / 6 * d * d * d, c = 3 * M_PI * eta * d;
  Group group{"Drag and lubrication",
              "A sphere of 33 um in the paper's fluid: Stokes' terminal velocity under a force, relaxation with m / c, "
              "and two spheres that squeeze the film between them: "
              "v = v0 - a/m* ln(h0/h), a = 3 pi eta d^2 / 8; the film under a sphere that a force presses on a floor, "
              "with implicit films at a step 130 times the explicit limit. Limits: first order in the step, 1000 to "
              "2000 steps a response time; 1e-9 for the final state.",
              {}};
  const auto scene = [&](double step) {
    Scene s = laboratory_scene({3e6, 0.35, rho, d}, step);
    s.fluid.viscosity = eta;
    return s;
  };
  for (const Integrator integrator : {Integrator::verlet, Integrator::implicit_drag}) {
    Scene s = scene(mass / c / 2000);
    s.drag.enabled = true;
    s.flow.source = FlowSource::uniform;
    s.flow.velocity = {5e-3, 0, 0};
    s.body_force = {0, 0, -1e-11};
    s.time.integrator = integrator;
    const std::string name = integrator == Integrator::verlet ? "explicit" : "implicit";
    Laboratory lab(s, {{.radius = d / 2}});
    lab.run_until(mass / c);
    const double t = lab->time() - lab->model().dt / 2;
    group.checks.push_back(
        {name + " drag: relaxation after m/c, v / u", 1 - std::exp(-t * c / mass), lab.velocity(0).x / 5e-3, 1e-3});
    lab.run_until(30 * mass / c);
    group.checks.push_back({name + " drag: carried with the fluid [m/s]", 5e-3, lab.velocity(0).x, 1e-9});
    group.checks.push_back(
        {name + " drag: terminal velocity F / (3 pi eta d) [m/s]", -1e-11 / c, lab.velocity(0).z, 1e-9});
  }
  const double a = 3 * M_PI * eta * d * d / 8, h0 = 5e-6, v0 = 0.05;
  for (const Integrator integrator : {Integrator::verlet, Integrator::implicit_fluid}) {
    Scene s = scene(2e-9);
    s.lubrication.enabled = true;
    s.lubrication.cutoff = d / 2;
    s.time.integrator = integrator;
    const std::string name = integrator == Integrator::verlet ? "explicit" : "implicit";
    Laboratory lab(s, {{.radius = d / 2, .vx = v0 / 2}, {.radius = d / 2, .x = d + h0, .vx = -v0 / 2}});
    for (const double time : {1e-5, 3e-5, 6e-5}) {
      lab.run_until(time);
      // Back from the half step at which the velocity stands.
      const double v = (lab.velocity(0) - lab.velocity(1)).x;
      const double h = (lab.position(1) - lab.position(0)).x - d + v * lab->model().dt / 2;
      group.checks.push_back({fmt::format("{} squeezed film at {} s: approach [m/s]", name, time),
                              v0 - a / (mass / 2) * std::log(h0 / h), v, 2e-3});
    }
  }
  group.checks.push_back(pressed_film(scene(1)));
  return group;
}

}  // namespace clogflow::verification
