// Two spheres, or a sphere and a wall, hit each other: Hertz's impact and the restitution wanted.
#include <gtest/gtest.h>

#include "tests/dem/laboratory.hpp"

namespace clogflow::test {
namespace {

/// What was seen of a head-on impact.
struct Impact {
  double force = 0;     ///< largest [N]
  double least = 0;     ///< smallest force while in contact, repulsive positive [N]
  double overlap = 0;   ///< largest [m]
  double duration = 0;  ///< [s]
  double restitution = 0;
};

/// Two equal spheres, each at half the closing speed.
Impact collide(const Scene& scene, double speed) {
  const double r = scene.particles.diameter / 2, gap = 0.1 * speed * scene.time.step;
  Laboratory lab(scene, {{.radius = r, .x = -r - gap, .vx = speed / 2}, {.radius = r, .x = r + gap, .vx = -speed / 2}});
  Impact impact{.least = 1e300};
  for (bool met = false;;) {
    lab->compute_forces();
    const bool touching = lab->pair_tally().contacts > 0;
    if (met && !touching) break;
    if (touching) {
      met = true;
      const double force = -lab.force(0).x;
      impact.force = std::max(impact.force, force);
      impact.least = std::min(impact.least, force);
      impact.overlap = std::max(impact.overlap, lab->pair_tally().largest_overlap);
      // A contact whose dashpot would pull has ended for the balance of forces.
      if (force > 0) impact.duration += lab->model().dt;
    }
    lab->advance();
  }
  impact.restitution = (lab.velocity(1) - lab.velocity(0)).x / speed;
  return impact;
}

/// Chung & Ooi (2011), test 1: glass spheres of 10 mm radius at 10 m/s each.
TEST(Impact, OfGlassSpheresIsChungAndOoisFirst) {
  const Impact glass = collide(laboratory_scene({48e9, 0.2, 2800, 0.02}, 1e-8), 20);
  // Limits: Hertz's closed form, to the error of 4000 steps an impact.
  EXPECT_NEAR(glass.force, 10.697e3, 1e-3 * 10.697e3);
  EXPECT_NEAR(glass.overlap, 274.1e-6, 1e-3 * 274.1e-6);
  EXPECT_NEAR(glass.duration, 40.34e-6, 2e-3 * 40.34e-6);
  EXPECT_NEAR(glass.restitution, 1, 1e-4);
}

TEST(Impact, OfLimestoneSpheres) {
  const Impact stone = collide(laboratory_scene({20e9, 0.25, 2500, 0.02}, 1e-8), 20);
  EXPECT_NEAR(stone.force, 7.108e3, 1e-3 * 7.108e3);
  EXPECT_NEAR(stone.overlap, 368e-6, 1e-3 * 368e-6);
  EXPECT_NEAR(stone.duration, 54.2e-6, 2e-3 * 54.2e-6);
}

TEST(Impact, BetweenSpheresKnowsNothingOfTheWalls) {
  Scene scene = laboratory_scene({48e9, 0.2, 2800, 0.02}, 1e-8);
  scene.contact.restitution = 0.8;
  const double alone = collide(scene, 20).restitution;
  scene.contact.wall_restitution = 0.3;
  EXPECT_EQ(collide(scene, 20).restitution, alone);
}

class Restitution : public testing::TestWithParam<double> {};

TEST_P(Restitution, OutIsRestitutionIn) {
  Scene scene = laboratory_scene({48e9, 0.2, 2800, 0.02}, 2e-8);
  scene.contact.restitution = GetParam();
  const Impact impact = collide(scene, 2);
  // First order in the step through the dashpot: 3000 steps an impact.
  EXPECT_NEAR(impact.restitution, GetParam(), 2e-3);
  EXPECT_GE(impact.least, 0) << "a dry contact cannot pull";
}

INSTANTIATE_TEST_SUITE_P(FromElasticToOverdamped, Restitution,
                         testing::Values(1.0, 0.9, 0.7, 0.5, 0.3, 0.135, 0.1, 0.05));

TEST(Restitution, DoesNotDependOnTheSpeed) {
  // The dashpot that goes with sqrt(m k), k the Hertz stiffness, is made for this.
  Scene scene = laboratory_scene({48e9, 0.2, 2800, 0.02}, 2e-8);
  scene.contact.restitution = 0.6;
  const double slow = collide(scene, 0.2).restitution, fast = collide(scene, 20).restitution;
  EXPECT_NEAR(slow, fast, 2e-3);
}

TEST(Restitution, HoldsForMicrometresAsForCentimetres) {
  Scene scene = laboratory_scene({3e6, 0.35, 1062, 33e-6}, 2e-9);
  scene.contact.restitution = 0.7;
  EXPECT_NEAR(collide(scene, 1e-3).restitution, 0.7, 2e-3);
}

TEST(WallImpact, GivesTheSameRestitution) {
  for (const double e : {0.9, 0.5}) {
    Scene scene = laboratory_scene({70e9, 0.33, 2699, 0.2}, 5e-7);
    scene.contact.restitution = e;
    set_floor(scene, 10);
    Laboratory lab(scene, {{.radius = 0.1, .z = 0.1 + 1e-9, .vz = -0.2}});
    lab.run_until(2e-3);
    EXPECT_NEAR(lab.velocity(0).z, 0.2 * e, 0.2 * 2e-3);
    EXPECT_NEAR(lab.velocity(0).x, 0, 1e-12);
  }
}

}  // namespace
}  // namespace clogflow::test
