// Friction of species: which coefficients a pair and a wall have, and that spheres feel them.
#include "dem/contact/species_friction.hpp"

#include <gmock/gmock.h>

#include "dem/contact/laws.hpp"
#include "tests/dem/laboratory.hpp"

namespace clogflow::test {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(MixedFriction, IsTheHarmonicMean) {
  EXPECT_DOUBLE_EQ(mixed_friction(0.2, 0.6), 0.3);
  EXPECT_DOUBLE_EQ(mixed_friction(0.6, 0.2), 0.3);
  EXPECT_DOUBLE_EQ(mixed_friction(0.1, 0.4), 0.16);
  EXPECT_EQ(mixed_friction(0.6, 0.6), 0.6);
  EXPECT_EQ(mixed_friction(0, 0.6), 0);
  EXPECT_EQ(mixed_friction(0.6, 0), 0);
  EXPECT_EQ(mixed_friction(0, 0), 0);
}

/// One species that names the sliding friction of its surface, one that names nothing, one that names walls.
Scene three_species(const std::string& contact = "") {
  return parse_scene(R"(
[particles]
species = [{diameter = "30 um", share = 0.4, friction = {sliding = 0.2}}, {diameter = "33 um", share = 0.3},
           {diameter = "36 um", share = 0.3, wall_friction = {sliding = 0, torsion = 0.05}}]
density = "1062 kg/m3"
[time]
end = "1 s"
[contact]
youngs_modulus = "3 MPa"
poisson_ratio = 0.35
friction = {sliding = 0.6, rolling = 0.1, torsion = 0.3}
)" + contact,
                     "three");
}

TEST(SpeciesFriction, OfEachPairByHand) {
  const Laws laws = make_laws(three_species());
  const double sliding[3][3] = {{0.2, 0.3, 0.3}, {0.3, 0.6, 0.6}, {0.3, 0.6, 0.6}};
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      const FrictionLaw pair = laws.pair.friction.between(a, b);
      EXPECT_DOUBLE_EQ(pair.sliding, sliding[a][b]) << a << b;
      EXPECT_EQ(pair.rolling, 0.1);
      EXPECT_EQ(pair.torsion, 0.3);
    }
  }
  EXPECT_EQ(laws.pair.friction.sliding, 0.6) << "the largest";
}

TEST(SpeciesFriction, WithWallsIsItsOwnThenThatOfTheSceneThenThatOfItsSurface) {
  const auto with_wall = [](const Scene& scene, int species) {
    return make_laws(scene).wall.contact.friction.between(species, 0);
  };
  const Scene plain = three_species(), walls = three_species("wall_friction = {sliding = 0.4}\n");
  EXPECT_EQ(with_wall(plain, 0).sliding, 0.2) << "as between particles";
  EXPECT_EQ(with_wall(plain, 1).sliding, 0.6);
  EXPECT_EQ(with_wall(walls, 0).sliding, 0.4) << "given for all";
  EXPECT_EQ(with_wall(walls, 0).rolling, 0.1);
  EXPECT_EQ(with_wall(walls, 1).sliding, 0.4);
  EXPECT_EQ(with_wall(walls, 2).sliding, 0) << "its own";
  EXPECT_EQ(with_wall(walls, 2).torsion, 0.05);
  EXPECT_EQ(with_wall(walls, 2).rolling, 0.1);
}

TEST(SpeciesFriction, OutlivesTheModelThatItWasCopiedFrom) {
  auto first = std::make_unique<Laws>(make_laws(three_species()));
  const Laws copy = *first;
  first.reset();
  EXPECT_DOUBLE_EQ(copy.pair.friction.between(0, 1).sliding, 0.3);
}

TEST(SpeciesFriction, IsReadBackAsItIsPrinted) {
  const Scene scene = three_species("wall_friction = {sliding = 0.4}\n");
  const std::string text = effective_scene(scene);
  EXPECT_THAT(text, HasSubstr("friction = {sliding = 0.2, rolling = 0.1, torsion = 0.3}, "
                              "wall_friction = {sliding = 0.4, rolling = 0.1, torsion = 0.3}"));
  const Scene again = parse_scene(text, "again");
  EXPECT_EQ(again.particles.species, scene.particles.species);
  EXPECT_EQ(effective_scene(again), text);
  Scene common = scene;
  for (Species& kind : common.particles.species) kind.friction = kind.wall_friction = common_friction;
  EXPECT_THAT(effective_scene(common), Not(HasSubstr("share = 0.4, friction")));
}

/// Spheres of two species side by side on one floor.
struct TwoOnAFloor {
  static constexpr double r = 0.5, load = 1000, speed = 0.1;
  Scene scene = laboratory_scene({1e9, 0.3, 1000, 2 * r}, 1e-5);
  double mass = 1000 * 4.0 / 3 * M_PI * r * r * r, inertia = 0.4 * mass * r * r;
  Particle first, second;

  TwoOnAFloor(const Friction& a, const Friction& b) {
    set_floor(scene, 200);
    scene.contact.restitution = 0.5;
    scene.body_force = {0, 0, -load};
    scene.particles.species = {{2 * r, 0.5, 0, {}, a}, {2 * r, 0.5, 0, {}, b}};
    // Where the floor carries the load: (3 F / (4 E* sqrt r))^(2/3), E* = E / (2 (1 - nu^2)).
    const double overlap = std::pow(3 * load * 2 * (1 - 0.09) / (4 * 1e9 * std::sqrt(r)), 2.0 / 3);
    first = {.radius = r, .z = r - overlap};
    first.mass = mass, first.inertia = inertia;
    second = first;
    second.x = 10, second.species = 1;
  }
};

TEST(SpeciesFriction, EachSlidesOnTheFloorByItsOwn) {
  TwoOnAFloor two({.sliding = 0.1}, {.sliding = 0.4});
  two.first.vx = two.second.vx = two.speed;
  Laboratory lab(two.scene, {two.first, two.second});
  // A third of what the rougher one slips: 2/7 u m / (mu F).
  lab.run_until(2.0 / 7 * two.speed * two.mass / (0.4 * two.load) / 3);
  const double t = lab->time() - 0.5e-5;
  EXPECT_NEAR(lab.velocity(0).x, two.speed - 0.1 * two.load / two.mass * t, 2e-4 * two.speed);
  EXPECT_NEAR(lab.velocity(1).x, two.speed - 0.4 * two.load / two.mass * t, 2e-4 * two.speed);
}

TEST(SpeciesFriction, EachRollsAndTwistsByItsOwn) {
  TwoOnAFloor two({.rolling = 0.2}, {.torsion = 0.1});
  const double spin = two.speed / two.r;
  two.first.wy = two.second.wy = spin;
  two.first.wz = two.second.wz = spin;
  Laboratory lab(two.scene, {two.first, two.second});
  lab.run_until(0.5 * spin * two.inertia / (0.2 * two.r * two.load));
  const double turned = two.r * two.load / two.inertia * (lab->time() - 0.5e-5);
  EXPECT_NEAR(lab.spin(0).y, spin - 0.2 * turned, 5e-3 * spin);
  EXPECT_EQ(lab.spin(0).z, spin) << "no torsion";
  EXPECT_EQ(lab.spin(1).y, spin) << "no rolling";
  EXPECT_NEAR(lab.spin(1).z, spin - 2 * 0.1 * turned, 5e-3 * spin);
}

/// Change of the tangential over that of the normal velocity in a glancing impact that slips to its end: mu of the
/// pair.
double glancing(const Scene& scene, int first, int second) {
  const double r = 0.01, v = 0.01;
  Particle a{.radius = r}, b = a;
  a.x = -1.0000001 * r, a.vx = v, a.vy = 6 * v, a.species = first;
  b.x = 1.0000001 * r, b.vx = -v, b.vy = -6 * v, b.species = second;
  Laboratory lab(scene, {a, b});
  lab.run_until(1e-3);
  return (6 * v - lab.velocity(0).y) / (v - lab.velocity(0).x);
}

TEST(SpeciesFriction, OfAPairThatGlancesOff) {
  Scene scene = laboratory_scene({}, 5e-7);
  scene.particles.species = {
      {0.02, 0.4, 0, {.sliding = 0.2}, {}}, {0.02, 0.3, 0, {.sliding = 0.6}, {}}, {0.02, 0.3, 0, {}, {}}};
  EXPECT_NEAR(glancing(scene, 0, 0), 0.2, 1e-3);
  EXPECT_NEAR(glancing(scene, 0, 1), 0.3, 1e-3);
  EXPECT_NEAR(glancing(scene, 1, 0), 0.3, 1e-3);
  EXPECT_NEAR(glancing(scene, 1, 1), 0.6, 1e-3);
  EXPECT_NEAR(glancing(scene, 2, 1), 0, 1e-3) << "0 of one is 0 of the pair";
}

}  // namespace
}  // namespace clogflow::test
