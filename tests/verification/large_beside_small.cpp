// Static friction between spheres of very different size: what is held stays, and what rolls is not caught.
#include <algorithm>

#include "tests/dem/laboratory.hpp"
#include "tests/verification/check.hpp"

namespace clogflow::verification {

using test::Laboratory;
using test::laboratory_scene;

namespace {

/// Mass of the large spheres over their own: while the small one moves they do not, by any digit.
constexpr double immovable = 1e24;

/// Two large spheres along x, which do not move, and a small one, number 0.
struct Three {
  Laboratory lab;

  Three(const Scene& scene, const Particle& small, double large, double apart)
      : lab(scene, {small, {.radius = large, .x = -apart / 2}, {.radius = large, .x = apart / 2}}) {
    for (const int i : {1, 2}) {
      ParticleState& p = lab->particles()[lab.at(i)];
      p.mass *= immovable, p.inertia *= immovable;
    }
  }
};

double ball(double density, double radius) { return density * 4.0 / 3 * M_PI * std::pow(radius, 3); }

/// A small sphere clamped between two large ones, with a load across within the cone of friction.
struct Clamp {
  double ratio;       ///< radius of the large spheres over that of the small one
  double step_share;  ///< step over the limit of stability 2 sqrt(m / k)
};

struct Held {
  double yields;   ///< displacement over F / (2 k_t)
  double creep;    ///< displacement in the second half of the steps over F / (2 k_t)
  double kinetic;  ///< energy at the end over F^2 / (4 k_t)
};

constexpr int held_steps = 200000;

Held hold(const Clamp& clamp) {
  const test::Substance paper{3e6, 0.35, 1062, 33e-6};
  const double r = paper.diameter / 2, large = clamp.ratio * r, mu = 0.5;
  const double effective = reduced(r, large), overlap = 5e-3 * r;
  const double modulus = paper.youngs_modulus / (2 * (1 - 0.35 * 0.35));
  const double shear = paper.youngs_modulus / (2 * 1.35) / (2 * (2 - 0.35));
  const double root = std::sqrt(effective * overlap);
  const double normal = 4.0 / 3 * modulus * root * overlap, spring = 2.0 / 3 * 8 * shear * root;
  // Twice this while the load comes on at once, and friction holds up to mu.
  const double load = 2 * 0.4 * mu * normal;
  const double mass = ball(paper.density, r);
  Scene scene = laboratory_scene(paper, clamp.step_share * 2 * std::sqrt(mass / (2 * 2 * modulus * root)));
  scene.contact.restitution = 0.5;
  test::set_friction(scene, {.sliding = mu});
  scene.body_force = {0, 0.6 * load, -0.8 * load};
  Three three(scene, {.radius = r}, large, 2 * (r + large - overlap));
  Laboratory& lab = three.lab;
  for (int k = 0; k < held_steps / 2; ++k) lab.step();
  const Vec3 half = lab.position(0);
  for (int k = 0; k < held_steps / 2; ++k) lab.step();
  const double yield = load / (2 * spring);
  const Vec3 v = lab.velocity(0), w = lab.spin(0);
  const double kinetic = 0.5 * mass * dot(v, v) + 0.2 * mass * r * r * dot(w, w);
  return {lab.position(0).norm() / yield, (lab.position(0) - half).norm() / yield, kinetic / (0.5 * load * yield)};
}

}  // namespace

Group held_beside_large() {
  Group group{
      "Small spheres held by large ones",
      "A sphere of 33 um (E = 3 MPa, friction 0.5) clamped by an overlap of 5e-3 r between two spheres that do not "
      "move, 1 to 20 times as large, under a load across of 0.2 of the clamping force at each contact: well inside "
      "the cone, also while the load, put on at once, overshoots. 2e5 steps of 0.05 and 0.4 of 2 sqrt(m/k). It must "
      "yield by F / (2 k_t), Mindlin's springs, and then rest: no creep, no energy. Limit of the first: the spheres' "
      "curvature, delta / r; of the others: rounding.",
      {}};
  for (const double share : {0.05, 0.4})
    for (const double ratio : {1.0, 3.0, 5.0, 10.0, 20.0}) {
      const Held held = hold({ratio, share});
      const std::string name = fmt::format("{} to 1, step {}", ratio, share);
      group.checks.push_back({name + ": yields by", 1, held.yields, 1e-2});
      group.checks.push_back({name + ": creep", 0, held.creep, 1e-9, false});
      group.checks.push_back({name + ": kinetic energy", 0, held.kinetic, 1e-18, false});
    }
  return group;
}

namespace {

constexpr double g = 9.81;

/// Two large spheres that touch, and a small one that rolls down in the groove between them, 1 degree off the top.
struct Groove {
  double ratio;  ///< radius of the large spheres over that of the small one
  double friction = 0.5;
  double step = 1e-6;  ///< [s]
  double small = 0.25e-3, density = 2500;

  double large() const { return ratio * small; }
  double distance() const { return large() + small; }
  /// From the point where the large ones touch to the small one [m].
  double way() const { return std::sqrt(distance() * distance() - large() * large()); }
  double mass() const { return ball(density, small); }
  /// Inertia that the rolling sphere shows over its mass: it turns by v / (r l / D).
  double inertia() const { return 1 + 0.4 * std::pow(distance() / way(), 2); }
};

constexpr double degree = M_PI / 180;

struct Fall {
  double rolls;         ///< when it is 30 degrees off the top [s]
  double leaves, when;  ///< where nothing presses it into the groove any more [rad], [s]
};

/// A rigid sphere that rolls, slips where that takes more than friction gives, and leaves.
///   l theta'' = g sin theta - F / m,  F = m g sin theta (1 - 1 / inertia) <= mu N,
///   N = m (g cos theta - l theta'^2) D / l, of both contacts
Fall law_of(const Groove& groove) {
  const double l = groove.way(), dt = 1e-7;
  double angle = degree, rate = 0, time = 0;
  Fall fall{0, 0, 0};
  while (true) {
    const double pressed = (g * std::cos(angle) - l * rate * rate) * groove.distance() / l;
    if (pressed <= 0) break;
    const double friction = std::min(g * std::sin(angle) * (1 - 1 / groove.inertia()), groove.friction * pressed);
    rate += dt * (g * std::sin(angle) - friction) / l;
    angle += dt * rate;
    time += dt;
    if (fall.rolls == 0 && angle > 30 * degree) fall.rolls = time;
  }
  fall.leaves = angle, fall.when = time;
  return fall;
}

Scene groove_scene(const Groove& groove) {
  Scene scene = laboratory_scene({1e9, 0.3, groove.density, 2 * groove.small}, groove.step);
  scene.contact.law = "hooke";
  scene.contact.stiffness = 1e4;
  scene.contact.tangential_factor = 0.8235;
  scene.contact.tangential_damping = 0;
  scene.contact.restitution = 0.5;
  test::set_friction(scene, {.sliding = groove.friction});
  scene.body_force = {0, 0, -groove.mass() * g};
  return scene;
}

struct Rolling : Three {
  explicit Rolling(const Groove& groove)
      : Three(groove_scene(groove),
              {.radius = groove.small, .y = groove.way() * std::sin(degree), .z = groove.way() * std::cos(degree)},
              groove.large(), 2 * groove.large()) {}

  /// From the vertical [rad]
  double angle() const {
    const Vec3 x = lab.position(0);
    return std::atan2(x.y, x.z);
  }

  /// Where it touched last before a time [rad]
  double last_touch(double end) {
    double last = 0;
    while (lab->time() < end) {
      lab.step();
      if (lab->pair_tally().contacts > 1) last = angle();
    }
    return last;
  }
};

}  // namespace

Group rolling_between_large() {
  Group group{
      "A small sphere rolls down between large ones",
      "Velocities are known half a step before places. About the normal at the place, a sphere that rolls would "
      "seem to slip sideways, always the same way; the spring of that slip presses one that rolls between large "
      "spheres into their groove, and it sticks: Vyas, Ottino, Lueptow & Umbanhowar, Comput. Phys. Commun. 310 "
      "(2025) 109524. By our reckoning it never leaves where the groove is steeper than the cone of friction, from "
      "R / r = (1 + sqrt(1 + mu^2)) / mu^2 on. Their three spheres as in LAMMPS' example "
      "`examples/granular/in.sync_verlet`: 0.5 mm on two of 10 mm, k = 1e4 N/m, friction 0.5, step 1e-6 s, from 1 "
      "degree off the top. References: m v^2 / 2 in LAMMPS' log of that example, with its mended integrator; and a "
      "rigid sphere that rolls, slips and leaves, integrated alone, at other sizes, frictions and steps. Limits: "
      "1e-3 of the log, whose energies grow e-fold every 15,000 steps; of the angle 0.1 degrees, and 5 where it "
      "leaves, for springs also pull along the axis, which the law leaves out. One that is caught misses that by "
      "80 degrees and more.",
      {}};
  {
    struct Record {
      int step;
      double energy;
    };
    Rolling three(Groove{20});
    int step = 0;
    for (const Record& r : {Record{60000, 1.0535747e-12}, Record{99000, 1.5303816e-11}, Record{120000, 6.2344723e-11},
                            Record{141000, 2.3504868e-10}}) {
      for (; step < r.step; ++step) three.lab.step();
      const Vec3 v = three.lab.velocity(0);
      group.checks.push_back({fmt::format("20 to 1, m v^2 / 2 after {} steps [J]", r.step), r.energy,
                              0.5 * Groove{20}.mass() * dot(v, v), 1e-3});
    }
  }
  const auto add = [&](const Groove& groove) {
    const Fall law = law_of(groove);
    Rolling three(groove);
    const std::string name =
        fmt::format("{} to 1, friction {}, step {:.3g} us: ", groove.ratio, groove.friction, 1e6 * groove.step);
    three.lab.run_until(law.rolls);
    group.checks.push_back({name + "angle [deg]", 30, three.angle() / degree, 0.1, false});
    group.checks.push_back(
        {name + "leaves at [deg]", law.leaves / degree, three.last_touch(1.2 * law.when) / degree, 5, false});
  };
  for (const double friction : {0.5, 0.8})
    for (const double ratio : {1.0, 3.0, 5.0, 10.0, 20.0}) add({ratio, friction});
  for (const double ratio : {5.0, 10.0}) add({ratio, 0.8, 2e-7});
  return group;
}

}  // namespace clogflow::verification
