// Chung & Ooi tests 4 to 8: oblique and spinning impacts, against their digitised curves and, where
// the contact slips throughout, against the closed form.
#include "tests/dem/laboratory.hpp"
#include "tests/verification/check.hpp"
#include "tests/verification/reference_table.hpp"

namespace clogflow::verification {

using test::Laboratory;
using test::laboratory_scene;

namespace {

struct Impact {
  test::Substance substance;
  double friction = 0, restitution = 1;
  double normal = 0, tangential = 0, spin = 0;  ///< before: towards the wall, along x, about y
};

/// After an impact on a rigid wall.
struct Rebound {
  double normal, tangential, spin;  ///< [m/s], [m/s], [rad/s] about y
  double patch;                     ///< velocity of the contact patch along x [m/s]
};

/// Steps that the impact takes: the curves' last digit needs no more.
constexpr double steps_an_impact = 4000;

Scene scene_of(const Impact& impact) {
  const auto& s = impact.substance;
  const double r = s.diameter / 2;
  const double duration =
      2.94 * std::pow(1.25 * s.density * M_PI * (1 - s.poisson_ratio * s.poisson_ratio) / s.youngs_modulus, 0.4) * r /
      std::pow(impact.normal, 0.2);
  Scene scene = laboratory_scene(s, duration / steps_an_impact);
  scene.contact.wall_youngs_modulus = 1000 * s.youngs_modulus;
  scene.contact.restitution = impact.restitution;
  scene.contact.tangential_factor = 1;  // Mindlin's own, as in the codes compared there
  test::set_friction(scene, {.sliding = impact.friction});
  return scene;
}

Rebound on_wall(const Impact& impact) {
  Scene scene = scene_of(impact);
  const double r = impact.substance.diameter / 2, start = 1e-3 * impact.normal * scene.time.step;
  test::set_floor(scene, 1000 * r);
  Laboratory lab(scene,
                 {{.radius = r, .z = r + start, .vx = impact.tangential, .vz = -impact.normal, .wy = impact.spin}});
  for (bool met = false;;) {
    lab.step();
    const bool touching = lab->wall_tally().contacts > 0;
    if (met && !touching) break;
    met = met || touching;
  }
  const Vec3 v = lab.velocity(0), w = lab.spin(0);
  return {v.z, v.x, w.y, v.x - w.y * r};
}

const test::Substance aluminium_oxide{380e9, 0.23, 4000, 0.005}, small_alloy{70e9, 0.33, 2700, 0.005};

std::string at(const char* what, const char* name, double x) { return fmt::format("{}, {} {:.4g}", name, what, x); }

}  // namespace

Group oblique_constant_speed() {
  Group group{"Chung & Ooi 4: oblique impact at constant speed",
              "Sphere of 5 mm, 3.9 m/s, friction 0.092, restitution 0.98, rigid wall; incident angle from the normal. "
              "Limits are the digitisation's: "
              "0.02 of a coefficient, 15 rad/s of a spin of up to 620; 2e-3 against the closed form of gross sliding "
              "(the lever r - delta/2).",
              {}};
  struct Material {
    const char *name, *key;
    test::Substance substance;
  };
  for (const auto& [name, key, substance] : {Material{"aluminium oxide", "al_oxide", aluminium_oxide},
                                             Material{"aluminium alloy", "al_alloy", small_alloy}}) {
    const auto impact = [&, substance = substance](double degrees) {
      const double angle = degrees * M_PI / 180;
      return Impact{substance, 0.092, 0.98, 3.9 * std::cos(angle), 3.9 * std::sin(angle), 0};
    };
    for (const Point& p : reference_curve("chung_ooi_test4_tangential_restitution.csv", key)) {
      const Impact i = impact(p.x);
      group.checks.push_back(
          {at("tangential restitution at deg", name, p.x), p.y, on_wall(i).tangential / i.tangential, 0.02, false});
    }
    for (const Point& p : reference_curve("chung_ooi_test4_spin.csv", key))
      group.checks.push_back({at("|spin| [rad/s] at deg", name, p.x), -p.y, on_wall(impact(p.x)).spin, 15, false});
    for (const double degrees : {60.0, 80.0}) {
      const Impact i = impact(degrees);
      group.checks.push_back({at("slip law, spin [rad/s] at deg", name, degrees),
                              2.5 * 0.092 * 1.98 * i.normal / 0.0025, on_wall(i).spin, 2e-3});
    }
  }
  return group;
}

namespace {

/// The law itself, elastic, integrated by itself: a sphere on a rigid wall in units of its mass, its normal velocity
/// and the Hertz constant, so that F_n = z^1.5 and k_t = 6 G*/E* sqrt(z). All that decides is nu and incidence / mu.
struct Dimensionless {
  double patch, spin;  ///< of the rebound, over mu v_n
};

Dimensionless mindlin_rebound(double incidence, double mu, double poisson) {
  const double ratio = 6 * (1 - poisson) / (2 * (2 - poisson)), dt = 1e-5;
  double z = 0, approach = 1, patch = incidence * mu, spring = 0, impulse = 0;
  do {
    z += approach * dt / 2, spring += patch * dt / 2;
    const double normal = z > 0 ? std::pow(z, 1.5) : 0, stiffness = ratio * std::sqrt(std::max(z, 0.0));
    if (stiffness * std::abs(spring) > mu * normal) spring = std::copysign(mu * normal / stiffness, spring);
    const double friction = stiffness * spring;
    approach -= normal * dt;
    patch -= 3.5 * friction * dt;
    impulse += friction * dt;
    z += approach * dt / 2, spring += patch * dt / 2;
  } while (z > 0);
  return {patch / mu, 2.5 * impulse / mu};
}

}  // namespace

Group oblique_constant_normal() {
  Group group{
      "Chung & Ooi 5: oblique impact at constant normal velocity",
      "Sphere of 20 um, 5 m/s towards a rigid wall, friction 0.3, elastic; incidence and rebound of the contact patch "
      "over mu v_n. Steel: E = 208 GPa, nu = 0.3, 7850 kg/m3; polyethylene: "
      "E = 1 GPa, nu = 0.4, 1400 kg/m3. Published curve where the contact slips throughout (incidence from 6 on), "
      "limit: its digitisation. Below, the published curve of test 5 contradicts that of test 4 in the same "
      "dimensionless variables (incidence 0.96: |spin| 0.14 in test 4, which we meet; 1.25 in test 5), and no factor "
      "on the stiffness gives it (the best, 0.2 to 0.25, misses by 0.2 to 0.3); there the reference is the law itself, "
      "integrated "
      "alone in dimensionless form. Limits: the lever r - delta/2 of a sphere that is pressed in by 0.3 % (steel) and "
      "by 2 % (polyethylene) of its radius.",
      {}};
  struct Material {
    const char *name, *key;
    test::Substance substance;
    double lever;
  };
  const double mu = 0.3, v = 5;
  for (const auto& [name, key, substance, lever] :
       {Material{"steel", "steel", {208e9, 0.3, 7850, 2e-5}, 0.02},
        Material{"polyethylene", "polyethylene", {1e9, 0.4, 1400, 2e-5}, 0.1}}) {
    const auto rebound = [&, substance = substance](double incident) {
      return on_wall({substance, mu, 1, v, incident * mu * v, 0});
    };
    for (const Point& p : reference_curve("chung_ooi_test5_rebound_angle.csv", key))
      if (p.x > 5.9)
        group.checks.push_back({at("rebound at incidence", name, p.x), p.y, rebound(p.x).patch / (mu * v), 0.1, false});
    for (const Point& p : reference_curve("chung_ooi_test5_spin.csv", key))
      if (p.x > 5.9)
        group.checks.push_back(
            {at("|spin| at incidence", name, p.x), -p.y, rebound(p.x).spin * 1e-5 / (mu * v), 0.1, false});
    for (const double x : {0.3, 1.0, 2.0, 3.0, 4.0, 5.0, 8.0, 12.0}) {
      const Rebound ours = rebound(x);
      const Dimensionless law = mindlin_rebound(x, mu, substance.poisson_ratio);
      group.checks.push_back({at("law alone, rebound at", name, x), law.patch, ours.patch / (mu * v), lever, false});
      group.checks.push_back(
          {at("law alone, |spin| at", name, x), law.spin, ours.spin * 1e-5 / (mu * v), lever, false});
    }
  }
  return group;
}

namespace {

/// Tests 6 and 8: a sphere that spins hits with v_n = 0.2 m/s; x = 3.5 mu (1 + e) v_n / v_s decides.
constexpr double spin_mu = 0.4, spin_e = 0.5, spin_v = 0.2, spin_radius = 0.1;

double patch_speed_of(double x) { return 3.5 * spin_mu * (1 + spin_e) * spin_v / x; }

}  // namespace

Group spinning_on_wall() {
  Group group{"Chung & Ooi 6: a spinning sphere on a rigid wall",
              "Radius 0.1 m, 0.2 m/s, friction 0.4, restitution 0.5; tangential restitution of the contact patch beta "
              "over x = 3.5 mu (1 + e) v_n / v_s. While the contact slips "
              "throughout, beta = x - 1. Aluminium alloy: E = 70 GPa, nu = 0.33; nylon: E = 2.5 GPa, nu = 0.4. Beyond "
              "slip the curve depends on the tangential dashpot, which the "
              "benchmark leaves to the code: ours has the normal one's damping ratio, so the limit there is wide.",
              {}};
  struct Material {
    const char *name, *key;
    test::Substance substance;
  };
  for (const auto& [name, key, substance] : {Material{"aluminium alloy", "al_alloy", {70e9, 0.33, 2700, 0.2}},
                                             Material{"nylon", "nylon", {2.5e9, 0.4, 1000, 0.2}}}) {
    const auto beta = [&, substance = substance](double x) {
      const double patch = patch_speed_of(x);
      return -on_wall({substance, spin_mu, spin_e, spin_v, 0, -patch / spin_radius}).patch / patch;
    };
    for (const double x : {0.2, 0.5, 0.8})
      group.checks.push_back({at("slip law, beta at x =", name, x), x - 1, beta(x), 1e-3, false});
    for (const Point& p : reference_curve("chung_ooi_test6_beta.csv", key))
      group.checks.push_back({at("beta at x =", name, p.x), p.y, beta(p.x), p.x < 1 ? 0.02 : 0.35, false});
  }
  return group;
}

namespace {

struct PairMotion {
  Vec3 v0, v1, w0, w1;
};

/// Two spheres meet along x; returns what is left when they have parted.
PairMotion collide(const Scene& scene, const std::vector<Particle>& spheres, double second_mass_factor) {
  Laboratory lab(scene, spheres);
  const std::size_t second = lab.at(1);
  lab->particles()[second].mass *= second_mass_factor;
  lab->particles()[second].inertia *= second_mass_factor;
  for (bool met = false;;) {
    lab.step();
    const bool touching = lab->pair_tally().contacts > 0;
    if (met && !touching) break;
    met = met || touching;
  }
  return {lab.velocity(0), lab.velocity(1), lab.spin(0), lab.spin(1)};
}

}  // namespace

Group counter_spinning_pair() {
  Group group{"Chung & Ooi 7: two equal spheres with opposite spins",
              "0.2 m/s each, friction 0.4, restitution 0.5: the contact patches move alike, so no friction acts: no "
              "tangential velocity appears and the spins stay, exactly.",
              {}};
  for (const test::Substance& substance :
       {test::Substance{70e9, 0.33, 2700, 0.2}, test::Substance{120e9, 0.35, 8900, 0.2}})
    for (const double spin : {0.175, 2.0, 22.86}) {
      const Scene scene = scene_of({substance, spin_mu, spin_e, 2 * spin_v});
      const double r = spin_radius;
      const PairMotion after = collide(scene,
                                       {{.radius = r, .x = -r - 1e-9, .vx = spin_v, .wy = spin},
                                        {.radius = r, .x = r + 1e-9, .vx = -spin_v, .wy = -spin}},
                                       1);
      const std::string name = substance.density < 5000 ? "aluminium alloy" : "copper";
      group.checks.push_back(
          {fmt::format("{}, spin {} rad/s: tangential velocity [m/s]", name, spin), 0, after.v0.z, 1e-15, false});
      group.checks.push_back({fmt::format("{}, spin {} rad/s: spin after", name, spin), spin, after.w0.y, 1e-14});
      group.checks.push_back(
          {fmt::format("{}, spin {} rad/s: spin of the other", name, spin), -spin, after.w1.y, 1e-14});
    }
  return group;
}

Group spinning_on_heavy_sphere() {
  Group group{"Chung & Ooi 8: a spinning sphere on a heavy sphere",
              "As test 6, the wall replaced by a sphere at rest of 1e9 times the mass, of the same and of five times "
              "the radius: beta must be that of test 6, in "
              "the slip regime and beyond. Limit 1e-3: the overlap changes the lever. Published curve (case A) in the "
              "slip regime to its digitisation.",
              {}};
  const test::Substance alloy{70e9, 0.33, 2700, 0.2};
  for (const double size : {1.0, 5.0}) {
    const auto beta = [&](double x) {
      const double patch = patch_speed_of(x), r = spin_radius;
      // Both materials are the sphere's; the wall of test 6 was rigid, but the ratio of the springs is the same.
      const PairMotion after = collide(
          scene_of({alloy, spin_mu, spin_e, spin_v}),
          {{.radius = r, .z = (1 + size) * r + 1e-9, .vz = -spin_v, .wy = -patch / r}, {.radius = size * r}}, 1e9);
      return -(after.v0.x - after.w0.y * r) / patch;
    };
    const auto wall = [&](double x) {
      const double patch = patch_speed_of(x);
      return -on_wall({alloy, spin_mu, spin_e, spin_v, 0, -patch / spin_radius}).patch / patch;
    };
    for (const double x : {0.2, 0.6, 1.2, 2.0, 5.0, 12.0})
      group.checks.push_back(
          {fmt::format("size ratio {}, beta at x = {}, as on the wall", size, x), wall(x), beta(x), 1e-3, false});
    for (const Point& p : reference_curve("chung_ooi_test8_beta.csv", "case_a"))
      if (p.x < 1)
        group.checks.push_back(
            {fmt::format("size ratio {}, beta at x = {:.4g}, published", size, p.x), p.y, beta(p.x), 0.02, false});
  }
  return group;
}

}  // namespace clogflow::verification
