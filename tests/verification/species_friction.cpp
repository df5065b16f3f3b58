// Friction of species: two on one floor, and pairs that glance off each other.
#include "dem/physics/friction.hpp"
#include "tests/dem/laboratory.hpp"
#include "tests/verification/check.hpp"

namespace clogflow::verification {

using test::Laboratory;
using test::laboratory_scene;

namespace {

/// Spheres of 1 m and of two species side by side; the floor carries 1 kN of each.
void add_floor(Group& group) {
  constexpr double r = 0.5, load = 1000, u0 = 0.1, step = 1e-5, modulus = 1e9;
  Scene s = laboratory_scene({modulus, 0.3, 1000, 2 * r}, step);
  test::set_floor(s, 200);
  s.contact.restitution = 0.5;
  s.body_force = {0, 0, -load};
  const Friction kinds[] = {{0.1, 0.05, 0.02}, {0.4, 0.2, 0.1}};
  s.particles.species = {{2 * r, 0.5, 0, {}, kinds[0]}, {2 * r, 0.5, 0, {}, kinds[1]}};
  const double mass = 1000 * 4.0 / 3 * M_PI * r * r * r, inertia = 0.4 * mass * r * r;
  const double height = r - std::pow(3 * load * 2 * (1 - 0.09) / (4 * modulus * std::sqrt(r)), 2.0 / 3);
  Particle sliding{.radius = r, .z = height, .vx = u0}, turning{.radius = r, .y = 10, .z = height, .wz = u0 / r};
  std::vector<Particle> all{sliding, sliding, turning, turning};
  for (const int k : {1, 3}) all[k].species = 1, all[k].x = 10;
  Laboratory lab(s, all);
  // A third of what the rougher one slips.
  lab.run_until(2.0 / 7 * u0 * mass / (kinds[1].sliding * load) / 3);
  const double t = lab->time() - step / 2;
  for (const int k : {0, 1}) {
    const std::string name = fmt::format("mu = {}, mu_o = {}: ", kinds[k].sliding, kinds[k].torsion);
    group.checks.push_back({name + "velocity on the floor / u0", 1 - kinds[k].sliding * load / mass * t / u0,
                            lab.velocity(k).x / u0, 1e-3});
    group.checks.push_back({name + "twist on the floor / w0",
                            1 - 2 * kinds[k].torsion * r * load / inertia * t / (u0 / r), lab.spin(k + 2).z / (u0 / r),
                            2e-3});
  }
}

/// Change of the tangential over that of the normal velocity in an impact that slips to its end.
void add_pairs(Group& group) {
  constexpr double r = 0.01, v = 0.01;
  const double surface[] = {0.2, 0.6, 0};
  Scene s = laboratory_scene({}, 5e-7);
  for (const double mu : surface) s.particles.species.push_back({2 * r, 1.0 / 3, 0, {.sliding = mu}, {}});
  const std::pair<int, int> pairs[] = {{0, 0}, {0, 1}, {1, 1}, {1, 2}};
  const double wanted[] = {0.2, 0.3, 0.6, 0};
  for (int k = 0; k < 4; ++k) {
    const auto [first, second] = pairs[k];
    Particle a{.radius = r, .x = -1.0000001 * r, .vx = v, .vy = 6 * v}, b = a;
    b.x = -a.x, b.vx = -v, b.vy = -a.vy;
    a.species = first, b.species = second;
    Laboratory lab(s, {a, b});
    lab.run_until(1e-3);
    const Vec3 left = lab.velocity(0);
    group.checks.push_back(
        {fmt::format("surfaces of {} and {}: impulse along over across the contact", surface[first], surface[second]),
         wanted[k], (6 * v - left.y) / (v - left.x), 3e-3, wanted[k] > 0});
  }
}

}  // namespace

Group species_friction() {
  Group group{
      "Friction of species",
      "Two species on one floor: gross sliding u0 - mu F t / m and decay of a twist, each by its own "
      "coefficients. Pairs that glance off each other and slip to the end: the impulse along the contact over "
      "that across it is the pair's mu, the harmonic mean 2 a b / (a + b) of its surfaces as in MercuryDPM. "
      "Limits: length of the springs, overlap over the radius, the 5e-4 rad that the contact turns in an impact.",
      {}};
  add_floor(group);
  add_pairs(group);
  return group;
}

}  // namespace clogflow::verification
