// Chung & Ooi tests 1 to 3: head-on impacts.
#include "dem/physics/hertz.hpp"
#include "tests/dem/laboratory.hpp"
#include "tests/verification/check.hpp"

namespace clogflow::verification {

using test::Laboratory;
using test::laboratory_scene;

namespace {

/// Kratos' own limit for these tests, and the task's.
constexpr double one_percent = 0.01;

struct Impact {
  double force = 0, overlap = 0, duration = 0;
  Vec3 velocity;  ///< of particle 0 afterwards [m/s]
};

/// Runs until the contact that comes is over.
Impact follow(Laboratory& lab) {
  Impact impact;
  for (bool met = false;;) {
    lab->compute_forces();
    const ContactTally pairs = lab->pair_tally(), walls = lab->wall_tally();
    const bool touching = pairs.contacts + walls.contacts > 0;
    if (met && !touching) break;
    if (touching) {
      met = true;
      impact.force = std::max(impact.force, lab.force(0).norm());
      impact.overlap = std::max({impact.overlap, pairs.largest_overlap, walls.largest_overlap});
      impact.duration += lab->model().dt;
    }
    lab->advance();
  }
  impact.velocity = lab.velocity(0);
  return impact;
}

Impact pair_impact(const test::Substance& substance, double speed) {
  Scene scene = laboratory_scene(substance, 1e-8);
  const double r = substance.diameter / 2;
  Laboratory lab(scene, {{.radius = r, .x = -r - 1e-9, .vx = speed}, {.radius = r, .x = r + 1e-9, .vx = -speed}});
  return follow(lab);
}

/// The wall is as good as rigid: a thousand times stiffer, as in the benchmark.
Scene wall_scene(const test::Substance& substance, double step) {
  Scene scene = laboratory_scene(substance, step);
  scene.contact.wall_youngs_modulus = 1000 * substance.youngs_modulus;
  test::set_floor(scene, 50 * substance.diameter);
  return scene;
}

/// Hertz's closed form of a head-on impact, Johnson, Contact Mechanics, sec. 11.4.
struct Hertz {
  double overlap, force, duration;
  Hertz(double mass, double radius, double modulus, double speed) {
    const double k = 4.0 / 3 * modulus * std::sqrt(radius);
    overlap = std::pow(5 * mass * speed * speed / (4 * k), 0.4);
    force = k * std::pow(overlap, 1.5);
    duration = 2.9432 * overlap / speed;
  }
};

}  // namespace

Group two_spheres_head_on() {
  Group group{"Chung & Ooi 1: two equal spheres head-on",
              "Radius 10 mm, 10 m/s each, elastic. Published peaks for glass; closed forms of Hertz for both.",
              {}};
  const Impact glass = pair_impact({48e9, 0.2, 2800, 0.02}, 10);
  group.checks.push_back({"glass, peak force, published [N]", 10.7039e3, glass.force, one_percent});
  group.checks.push_back({"glass, overlap, published [m]", 274e-6, glass.overlap, one_percent});
  group.checks.push_back({"glass, duration, published [s]", 40.48e-6, glass.duration, one_percent});
  struct Material {
    const char* name;
    test::Substance substance;
  };
  for (const auto& [name, s] :
       {Material{"glass", {48e9, 0.2, 2800, 0.02}}, Material{"limestone", {20e9, 0.25, 2500, 0.02}}}) {
    const double mass = s.density * M_PI / 6 * std::pow(s.diameter, 3);
    const Hertz hertz(mass / 2, s.diameter / 4, s.youngs_modulus / (2 * (1 - s.poisson_ratio * s.poisson_ratio)), 20);
    const Impact impact = pair_impact(s, 10);
    group.checks.push_back({std::string(name) + ", peak force, Hertz [N]", hertz.force, impact.force, 1e-4});
    group.checks.push_back({std::string(name) + ", overlap, Hertz [m]", hertz.overlap, impact.overlap, 1e-4});
    group.checks.push_back({std::string(name) + ", duration, Hertz [s]", hertz.duration, impact.duration, 1e-3});
  }
  return group;
}

Group sphere_on_rigid_wall() {
  Group group{"Chung & Ooi 2: sphere against a rigid wall",
              "Aluminium alloy, radius 0.1 m, 0.2 m/s, elastic, the wall 1000 times stiffer; Hertz's closed form with "
              "that wall. "
              "(The digitised published curve peaks at 11.33 kN and 50.0 um.)",
              {}};
  const test::Substance alloy{70e9, 0.33, 2699, 0.2};
  Laboratory lab(wall_scene(alloy, 1e-7), {{.radius = 0.1, .z = 0.1 + 1e-9, .vz = -0.2}});
  const Impact impact = follow(lab);
  const double mass = 2699 * 4.0 / 3 * M_PI * 1e-3;
  const Hertz hertz(mass, 0.1, 70e9 / (1 - 0.33 * 0.33) / 1.001, 0.2);
  group.checks.push_back({"peak force [N]", hertz.force, impact.force, one_percent});
  group.checks.push_back({"overlap [m]", hertz.overlap, impact.overlap, one_percent});
  group.checks.push_back({"duration [s]", hertz.duration, impact.duration, one_percent});
  group.checks.push_back({"overlap, published curve [m]", 50.0e-6, impact.overlap, 0.02});
  group.checks.push_back({"peak force, published curve [N]", 11.33e3, impact.force, 0.02});
  return group;
}

Group restitution_sweep() {
  Group group{
      "Chung & Ooi 3: restitution out = restitution in",
      "Aluminium oxide (E = 380 GPa, nu = 0.23, 4000 kg/m3) and cast iron (E = 104 GPa, nu = 0.25, 7200 "
      "kg/m3), radius 2.5 mm and 10 mm, 3.9 and 0.2 m/s "
      "against a rigid wall. Our dashpot ends contact when the force has fallen to zero, so it never pulls; "
      "its constant is chosen for exactly that. In the last rows contact.restitution is 0.9 and the wall has its own, "
      "contact.wall_restitution.",
      {}};
  struct Material {
    const char* name;
    test::Substance substance;
    double speed;
  };
  for (const auto& [name, s, speed] : {Material{"aluminium oxide", {380e9, 0.23, 4000, 0.005}, 3.9},
                                       Material{"cast iron", {104e9, 0.25, 7200, 0.02}, 0.2}})
    for (const double e : {0.05, 0.1, 0.2, 0.4, 0.6, 0.8, 0.9, 1.0}) {
      Scene scene = wall_scene(s, speed > 1 ? 2e-9 : 2e-8);
      scene.contact.restitution = e;
      Laboratory lab(scene, {{.radius = s.diameter / 2, .z = s.diameter / 2 + 1e-10, .vz = -speed}});
      group.checks.push_back({fmt::format("{}, e = {}", name, e), e, follow(lab).velocity.z / speed, one_percent});
    }
  for (const double e : {0.3, 0.8}) {
    const test::Substance iron{104e9, 0.25, 7200, 0.02};
    Scene scene = wall_scene(iron, 2e-8);
    scene.contact.restitution = 0.9, scene.contact.wall_restitution = e;
    Laboratory lab(scene, {{.radius = iron.diameter / 2, .z = iron.diameter / 2 + 1e-10, .vz = -0.2}});
    group.checks.push_back(
        {fmt::format("cast iron, e of the wall = {}", e), e, follow(lab).velocity.z / 0.2, one_percent});
  }
  return group;
}

}  // namespace clogflow::verification
