// What an impact must not do: make energy, or spin where nothing turns the sphere. The guards of LAMMPS' granular
// suite, and what else of that kind can be said in numbers.
#include <algorithm>

#include "tests/dem/laboratory.hpp"
#include "tests/verification/check.hpp"

namespace clogflow::verification {

using test::Laboratory;
using test::laboratory_scene;

namespace {

/// The sphere that hits, and what it is made of.
constexpr double radius = 2.5e-3;
const test::Substance alloy{70e9, 0.33, 2700, 2 * radius};

/// Steps that an impact takes.
constexpr double steps_an_impact = 500;

struct Impact {
  Friction friction;
  double restitution = 1;
  double speed = 3.9;     ///< [m/s]
  double degrees = 76;    ///< from the normal
  double partner = 0;     ///< its radius over that of the sphere; 0: a wall
  Vec3 spin = {0, 0, 0};  ///< before [rad/s]
};

struct Overlapped {
  double overlap, duration;  ///< of a head-on impact, by Hertz [m], [s]
};

/// K. L. Johnson, Contact Mechanics, Eq. (11.21) and (11.24).
Overlapped hertz(const Impact& impact) {
  const double normal = impact.speed * std::cos(impact.degrees * M_PI / 180), cube = std::pow(impact.partner, 3);
  const double share = impact.partner > 0 ? cube / (1 + cube) : 1;
  const double mass = share * alloy.density * 4.0 / 3 * M_PI * std::pow(radius, 3);
  const double effective = radius * (impact.partner > 0 ? impact.partner / (1 + impact.partner) : 1);
  const double modulus = alloy.youngs_modulus / (2 * (1 - alloy.poisson_ratio * alloy.poisson_ratio));
  const double overlap = std::pow(15 * mass * normal * normal / (16 * modulus * std::sqrt(effective)), 0.4);
  return {overlap, 2.943 * overlap / normal};
}

double energy(Laboratory& lab) {
  double sum = 0;
  for (const ParticleState& p : lab->particles().states)
    sum += 0.5 * p.mass * dot(p.velocity(), p.velocity()) + 0.5 * p.inertia * dot(p.spin(), p.spin());
  return sum;
}

/// Lets one contact come and go.
void meet(Laboratory& lab) {
  for (bool met = false;;) {
    lab.step();
    const bool touching = lab->pair_tally().contacts + lab->wall_tally().contacts > 0;
    if (met && !touching) return;
    met = met || touching;
  }
}

/// A sphere that comes down, moving along x, on a wall or on a sphere at rest.
struct Rebound {
  Vec3 velocity, spin;
  double energy;  ///< after over before
};

Rebound rebound(const Impact& impact, Scene scene) {
  scene.contact.restitution = impact.restitution;
  test::set_friction(scene, impact.friction);
  const double angle = impact.degrees * M_PI / 180;
  const double gap = 0.5 * impact.speed * std::cos(angle) * scene.time.step;
  const bool wall = impact.partner == 0;
  const Vec3& w = impact.spin;
  std::vector<Particle> spheres{{.radius = radius,
                                 .z = radius + gap,
                                 .vx = impact.speed * std::sin(angle),
                                 .vz = -impact.speed * std::cos(angle),
                                 .wx = w.x,
                                 .wy = w.y,
                                 .wz = w.z}};
  if (wall) {
    test::set_floor(scene, 1000 * radius);
  } else {
    spheres.push_back({.radius = impact.partner * radius, .z = -impact.partner * radius});
  }
  Laboratory lab(scene, spheres);
  const double before = energy(lab);
  meet(lab);
  return {lab.velocity(0), lab.spin(0), energy(lab) / before};
}

Rebound rebound(const Impact& impact) {
  return rebound(impact, laboratory_scene(alloy, hertz(impact).duration / steps_an_impact));
}

}  // namespace

Group no_energy_from_impacts() {
  Group group{
      "No energy from an impact",
      "LAMMPS' guard `dem04-legacy-hookehistory-grazing` (lammps/lammps, pull requests 5007 and 5113): 3.9 m/s at 76 "
      "degrees from the normal, linear spring of 2e7 N/m, friction 0.5, where its wall once gave 34 % more than came "
      "in. The reference there is LAMMPS' own record; the limit is the lever r - delta/2 of our torque. Then the "
      "largest energy after over that before, over incident angles of 0 to 88 degrees, 76 among them, without spin "
      "and with spin about all three axes: on a wall, on an equal sphere, on one three times as large; sliding "
      "alone, with rolling, with torsion, with both. Friction, rolling and torsion may each only take: no gain; the "
      "limit, 1e-6 as in LAMMPS' guard, is for the integrator, which gains 2e-8 in a head-on elastic impact.",
      {}};
  {
    const double e = 0.92469027185 / 0.94345;
    const Impact grazing{{.sliding = 0.5}, e, std::hypot(3.7839, 0.94345), std::atan2(3.7839, 0.94345) * 180 / M_PI};
    Scene scene = laboratory_scene(alloy, 1e-8);
    scene.contact.law = "hooke";
    scene.contact.stiffness = 2e7;
    scene.contact.tangential_factor = 2.0 / 7;
    const Rebound after = rebound(grazing, scene);
    group.checks.push_back({"LAMMPS' grazing impact: tangential velocity [m/s]", 2.8497777744, after.velocity.x, 1e-3});
    group.checks.push_back({"LAMMPS' grazing impact: normal velocity [m/s]", 0.92469027185, after.velocity.z, 1e-3});
    group.checks.push_back({"LAMMPS' grazing impact: spin [rad/s]", 934.122225618, after.spin.y, 1e-3});
    const double v2 = 2.8497777744 * 2.8497777744 + 0.92469027185 * 0.92469027185, w = 934.122225618 * radius;
    group.checks.push_back(
        {"LAMMPS' grazing impact: energy ratio", (v2 + 0.4 * w * w) / (3.9 * 3.9), after.energy, 1e-3});
  }
  struct Terms {
    const char* name;
    Friction friction;
  };
  for (const auto& [name, friction] :
       {Terms{"sliding", {.sliding = 0.5}}, Terms{"sliding, rolling", {.sliding = 0.5, .rolling = 0.3}},
        Terms{"sliding, torsion", {.sliding = 0.5, .torsion = 0.3}},
        Terms{"all", {.sliding = 0.5, .rolling = 0.3, .torsion = 0.3}}})
    for (const double restitution : {1.0, 0.7}) {
      double largest = 0;
      for (const double partner : {0.0, 1.0, 3.0})
        for (const double degrees : {0.0, 20.0, 40.0, 50.0, 60.0, 70.0, 76.0, 80.0, 88.0})
          for (const double spin : {0.0, 0.5}) {
            const double w = spin * 3.9 / radius;
            largest = std::max(largest, rebound({friction, restitution, 3.9, degrees, partner, {w, -w, w}}).energy);
          }
      group.checks.push_back(
          {fmt::format("{}, restitution {}: gain", name, restitution), 0, std::max(0.0, largest - 1), 1e-6, false});
    }
  return group;
}

Group no_spin_without_torque() {
  Group group{
      "No spin without a torque",
      "All friction terms on. Head-on: no arm, no spin. Without friction at 76 degrees: the spin and the tangential "
      "velocity that came are those that leave. Where the patch does not slip, v_t = w r, nothing acts on it but for "
      "the lever r - delta/2: a share of delta/(2 r) of the spin at most, delta Hertz' largest overlap. Pressed along"
      " the line of three centres: none, though sizes and directions are odd. Spins over v / r; limits are rounding.",
      {}};
  const Friction rough{.sliding = 0.5, .rolling = 0.3, .torsion = 0.3};
  const double unit = 3.9 / radius;
  for (const double restitution : {1.0, 0.5})
    for (const double partner : {0.0, 1.0, 3.0})
      group.checks.push_back({fmt::format("head-on, e = {}, partner's size {}", restitution, partner), 0,
                              rebound({rough, restitution, 3.9, 0, partner}).spin.norm() / unit, 1e-14, false});
  for (const double partner : {0.0, 1.0}) {
    const Vec3 spin{0, 100, 300};
    const Rebound after = rebound({{}, 0.7, 3.9, 76, partner, spin});
    group.checks.push_back({fmt::format("no friction, 76 degrees, partner's size {}: change of spin", partner), 0,
                            (after.spin - spin).norm() / unit, 1e-14, false});
    if (partner == 0)
      group.checks.push_back({"no friction, 76 degrees, wall: tangential velocity [m/s]",
                              3.9 * std::sin(76 * M_PI / 180), after.velocity.x, 1e-14});
  }
  for (const double degrees : {30.0, 76.0}) {
    const double spin = 3.9 * std::sin(degrees * M_PI / 180) / radius;
    const Impact impact{{.sliding = 0.5}, 0.7, 3.9, degrees, 0, {0, spin, 0}};
    const double lever = hertz(impact).overlap / (2 * radius);
    const Rebound after = rebound(impact);
    group.checks.push_back({fmt::format("no slip, {} degrees: spin [rad/s]", degrees), spin, after.spin.y, lever});
    group.checks.push_back({fmt::format("no slip, {} degrees: tangential velocity [m/s]", degrees), spin * radius,
                            after.velocity.x, lever});
  }
  {
    Scene scene = laboratory_scene(alloy, 1e-8);
    scene.contact.restitution = 0.7;
    test::set_friction(scene, rough);
    const Vec3 along = (1.0 / 3) * Vec3(1, 2, 2);
    const auto sphere = [&](double size, double place, double speed) {
      const Vec3 x = place * along, v = speed * along;
      return Particle{.radius = size, .x = x.x, .y = x.y, .z = x.z, .vx = v.x, .vy = v.y, .vz = v.z};
    };
    Laboratory lab(scene, {sphere(radius, -(1 + 3) * radius - 1e-9, 3.9), sphere(3 * radius, 0, 0),
                           sphere(2 * radius, (3 + 2) * radius + 1e-9, -3.9)});
    meet(lab);
    double largest = 0, aside = 0;
    for (const int i : {0, 1, 2}) {
      largest = std::max(largest, lab.spin(i).norm());
      aside = std::max(aside, (lab.velocity(i) - dot(lab.velocity(i), along) * along).norm());
    }
    group.checks.push_back({"three in a row: largest spin", 0, largest / unit, 1e-10, false});
    group.checks.push_back({"three in a row: largest velocity across", 0, aside / 3.9, 1e-10, false});
  }
  return group;
}

}  // namespace clogflow::verification
