// How fast the error of each force term falls with the time step.
#include "tests/dem/laboratory.hpp"
#include "tests/verification/check.hpp"

namespace clogflow::verification {

using test::Laboratory;
using test::laboratory_scene;

namespace {

/// One term in isolation: a scene, what moves in it, for how long. Contacts neither begin nor end on
/// the way, for that costs any integrator its order.
struct Case {
  const char* name;
  double order;
  Scene scene;
  std::vector<Particle> particles;
  double duration;
  bool spin = false;  ///< watch the angle (by the spin) rather than the place
};

/// Where things stand at the end: places of all particles, or the angle turned (sum of spin times step).
std::vector<double> outcome(const Case& c, int steps) {
  Scene scene = c.scene;
  scene.time.step = c.duration / steps;
  Laboratory lab(scene, c.particles);
  std::vector<double> angle(3 * c.particles.size(), 0.0), place;
  for (int k = 0; k < steps; ++k) {
    lab.step();
    for (std::size_t i = 0; i < c.particles.size(); ++i)
      for (int a = 0; a < 3; ++a) angle[3 * i + a] += lab.spin(static_cast<std::int64_t>(i))[a] * scene.time.step;
  }
  for (std::size_t i = 0; i < c.particles.size(); ++i)
    for (int a = 0; a < 3; ++a) place.push_back(lab.position(static_cast<std::int64_t>(i))[a]);
  return c.spin ? angle : place;
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return std::sqrt(sum);
}

/// From three runs, each with half the step of the one before: log2 of the ratio of their differences.
double measured_order(const Case& c) {
  const auto coarse = outcome(c, 100), middle = outcome(c, 200), fine = outcome(c, 400);
  return std::log2(distance(coarse, middle) / distance(middle, fine));
}

constexpr double r = 0.01;

Scene dry(double restitution, const Friction& friction = {}) {
  Scene s = laboratory_scene({1e7, 0.2, 2800, 2 * r}, 1e-6);
  s.contact.restitution = restitution;
  test::set_friction(s, friction);
  return s;
}

/// Two spheres, deep in contact, which move and spin against each other.
std::vector<Particle> pair(const Particle& motion) {
  Particle first = motion;
  first.radius = r;
  return {first, {.radius = r, .x = 1.98 * r}};
}

std::vector<Case> cases() {
  const double apart = 5e-4;  // s, a tenth of the contact's duration
  Scene fluid = laboratory_scene({3e6, 0.35, 1062, 33e-6}, 1e-8);
  fluid.fluid.viscosity = 1.8e-3;
  Scene drag = fluid, implicit = fluid, film = fluid;
  drag.drag.enabled = implicit.drag.enabled = true;
  drag.flow.source = implicit.flow.source = FlowSource::uniform;
  drag.flow.velocity = implicit.flow.velocity = {5e-3, 0, 0};
  implicit.time.integrator = Integrator::implicit_drag;
  film.lubrication.enabled = true;
  film.lubrication.cutoff = 16.5e-6;
  Scene implicit_film = film;
  implicit_film.time.integrator = Integrator::implicit_fluid;
  const std::vector<Particle> squeezed{{.radius = 16.5e-6, .vx = 0.025}, {.radius = 16.5e-6, .x = 38e-6, .vx = -0.025}};
  const Friction stick{.sliding = 1e4};
  Scene springs = dry(0.5, stick), still = dry(0.5, stick);
  springs.contact.tangential_damping = 0;
  Scene rolling_dashpot = dry(0.5, {.rolling = 1e4});
  return {{"Hertz spring", 2, dry(1), pair({}), apart},
          {"normal dashpot", 1, dry(0.5), pair({}), apart},
          {"sliding spring", 2, dry(1, stick), pair({.vy = 0.05, .wz = 3}), apart, true},
          {"sliding dashpot", 1, still, pair({.vy = 0.05, .wz = 3}), apart, true},
          {"rolling spring", 2, dry(1, {.rolling = 1e4}), pair({.wz = 3}), apart, true},
          {"rolling dashpot", 1, rolling_dashpot, pair({.wz = 3}), apart, true},
          {"torsion spring", 2, dry(1, {.torsion = 1e4}), pair({.wx = 3}), apart, true},
          {"torsion dashpot", 1, dry(0.5, {.torsion = 1e4}), pair({.wx = 3}), apart, true},
          {"drag, explicit", 1, drag, {{.radius = 16.5e-6}}, 5e-5},
          {"drag, implicit", 1, implicit, {{.radius = 16.5e-6}}, 5e-5},
          {"lubrication, explicit", 1, film, squeezed, 3e-5},
          {"lubrication, implicit", 1, implicit_film, squeezed, 3e-5}};
}

}  // namespace

Group orders() {
  Group group{"Order of convergence in the time step",
              "Differences of runs with 100, 200 and 400 steps. Springs follow places: second order. Dashpots, drag "
              "and lubrication take the velocity half a step before: first order (with "
              "the paper's step their error is what the closed forms above show).",
              {}};
  for (const Case& c : cases()) group.checks.push_back({c.name, c.order, measured_order(c), 0.25, false});
  return group;
}

}  // namespace clogflow::verification
