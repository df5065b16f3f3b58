// Spheres that stick: the force of the jump into contact, the pull-off force, the gap at which the contact breaks and
// the overlap without a load, of pairs and at a wall; the work that parts them.
#include <numbers>

#include "tests/dem/laboratory.hpp"
#include "tests/verification/check.hpp"

namespace clogflow::verification {

using test::Laboratory;
using test::laboratory_scene;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double w = 1e-3, modulus = 1e7, poisson = 0.3;               // [J/m2] [Pa] [-]
constexpr double own_radius = 20e-6, other_radius = 10e-6;             // [m]
constexpr double effective = modulus / (2 * (1 - poisson * poisson));  // E* of two equal materials [Pa]

double reduced_radius(bool at_wall) {
  return at_wall ? own_radius : own_radius * other_radius / (own_radius + other_radius);
}

/// 3/4 (pi^2 w^2 R* / E*^2)^(1/3)
double jkr_gap(double radius) { return 0.75 * std::cbrt(std::pow(pi * w / effective, 2) * radius); }

Scene sticky(const char* law, double density, double step) {
  Scene s = laboratory_scene({modulus, poisson, density, 2 * own_radius}, step);
  s.contact.law = law, s.contact.surface_energy = w;
  return s;
}

/// Forces along the line of the centres of a sphere that is led, too heavy to be stopped, towards another or the floor.
struct Led {
  double first = 0;   ///< when contact begins, repulsive positive [N]
  double least = 0;   ///< [N]
  double before = 0;  ///< just before contact [N]
  double broke = 0;   ///< gap where the contact ended [m]
};

/// \param apart gap at the start [m];  \param speed of parting [m/s], < 0: they approach
Led lead(const char* law, bool at_wall, double apart, double speed) {
  const double way = 4 * jkr_gap(reduced_radius(at_wall));
  constexpr int steps = 4000;
  Scene s = sticky(law, 1e16, way / std::abs(speed) / steps);
  std::vector<Particle> spheres{{.radius = own_radius, .z = own_radius + apart, .vz = speed}};
  if (at_wall) {
    test::set_floor(s, 1e-3);
  } else {
    spheres[0].z += 2 * other_radius;
    spheres.push_back({.radius = other_radius, .z = other_radius});
  }
  Laboratory lab(s, spheres);
  Led seen;
  bool touched = false;
  for (int k = 0; k < steps; ++k) {
    lab->compute_forces();
    const double force = lab.force(0).z;
    const bool touches = (at_wall ? lab->wall_tally() : lab->pair_tally()).contacts > 0;
    if (touches && !touched) seen.first = force;
    if (!touches && !touched) seen.before = force;
    if (!touches && touched && seen.broke == 0)
      seen.broke = lab.position(0).z - own_radius - (at_wall ? 0 : lab.position(1).z + other_radius);
    touched = touched || touches;
    seen.least = std::min(seen.least, force);
    lab->advance();
  }
  return seen;
}

/// Overlap at which an unloaded, braked pair of equal spheres comes to rest [m].
double resting_overlap(const char* law) {
  Scene s = sticky(law, 1000, 2e-9);
  s.contact.restitution = 0.1;
  Laboratory lab(s, {{.radius = own_radius}, {.radius = own_radius, .x = 2 * own_radius * (1 - 1e-6)}});
  lab.run_until(2e-4);
  return 2 * own_radius - (lab.position(1) - lab.position(0)).norm();
}

/// Speed after an elastic impact of equal spheres over the speed before; 0 where they stick.
double rebound(const char* law, double speed) {
  const double step = 1e-9;
  Laboratory lab(sticky(law, 1000, step), {{.radius = own_radius, .x = -own_radius - 1e-12, .vx = speed / 2},
                                           {.radius = own_radius, .x = own_radius + 1e-12, .vx = -speed / 2}});
  for (bool met = false; lab->time() < 1e-4;) {
    lab->compute_forces();
    const bool touching = lab->pair_tally().contacts > 0;
    if (met && !touching) return (lab.velocity(1) - lab.velocity(0)).x / speed;
    met = met || touching;
    lab->advance();
  }
  return 0;
}

/// 7.09 (w^5 R*^4 / E*^2)^(1/3) [J]
double work_of_parting(double radius) {
  return 7.09 * std::cbrt(std::pow(w, 5) * std::pow(radius, 4) / (effective * effective));
}

void add_law(Group& group, const std::string& law) {
  const bool soft = law == "jkr";
  for (const bool at_wall : {false, true}) {
    const double radius = reduced_radius(at_wall), gap = jkr_gap(radius);
    const double pull_off = (soft ? 1.5 : 2.0) * pi * w * radius;
    const std::string name = law + (at_wall ? ", at the wall: " : ", 20 um and 10 um: ");
    const Led in = lead(law.c_str(), at_wall, gap / 2, -1e-3), out = lead(law.c_str(), at_wall, -gap, 1e-3);
    group.checks.push_back({name + "force before touch [N]", 0, in.before, 1e-30, false});
    group.checks.push_back({name + "jump into contact [N]", -(soft ? 8.0 / 9 : 1) * pull_off, in.first, 1e-2});
    group.checks.push_back({name + "pull-off force [N]", pull_off, -out.least, soft ? 1e-5 : 1e-3});
    group.checks.push_back(
        {name + "gap where it breaks / 3/4 (pi^2 w^2 R*/E*^2)^(1/3)", soft ? 1.0 : 0.0, out.broke / gap, 2e-3, soft});
  }
}

}  // namespace

Group cohesion() {
  Group group{
      "Cohesion: jkr and dmt",
      "w = 1 mJ/m2, E = 10 MPa. A sphere of 20 um, too heavy to be stopped, is led to and from one of 10 um and a "
      "wall in steps of 1/1000 of the gap at which jkr breaks. Closed forms: pull-off 3/2 pi w R* (jkr) and "
      "2 pi w R* (dmt); jkr attracts with 8/9 of it at touch, and breaks at a gap of 3/4 (pi^2 w^2 R*/E*^2)^(1/3). "
      "No force before touch: both laws leave it out. Without a load jkr rests at the overlap a^2/(3 R*), "
      "a^3 = 9 pi w R*^2/(2 E*), dmt at Hertz' under the pull-off force. Elastic impacts of equal spheres lose "
      "the work of parting 7.09 (w^5 R*^4/E*^2)^(1/3) (Thornton & Ning 1998), dmt loses nothing. Limits: "
      "the way of one step, and for impacts the three digits of 7.09.",
      {}};
  add_law(group, "jkr");
  add_law(group, "dmt");
  const double radius = own_radius / 2, a = std::cbrt(4.5 * pi * w * radius * radius / effective);
  const double pressed = std::pow(2 * pi * w * radius / (4.0 / 3 * effective * std::sqrt(radius)), 2.0 / 3);
  group.checks.push_back({"jkr: overlap without a load [m]", a * a / (3 * radius), resting_overlap("jkr"), 1e-4});
  group.checks.push_back({"dmt: overlap without a load [m]", pressed, resting_overlap("dmt"), 1e-4});
  const double mass = 1000 * 4.0 / 3 * pi * std::pow(own_radius, 3);
  const double critical = std::sqrt(2 * work_of_parting(radius) / (mass / 2));
  group.checks.push_back({"jkr: rebound at 0.97 of the critical speed", 0, rebound("jkr", 0.97 * critical), 0, false});
  for (const double times : {1.1, 1.5, 3.0})
    group.checks.push_back({fmt::format("jkr: restitution at {} times the critical speed", times),
                            std::sqrt(1 - 1 / (times * times)), rebound("jkr", times * critical), 1e-2});
  group.checks.push_back({"dmt: restitution of an elastic impact", 1, rebound("dmt", 3 * critical), 5e-3});
  return group;
}

}  // namespace clogflow::verification
