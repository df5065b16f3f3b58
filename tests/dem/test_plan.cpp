// Dimensionless numbers by hand for the paper's scene, and what the plan makes of them.
#include <gmock/gmock.h>

#include "dem/physics/dimensionless.hpp"
#include "dem/physics/hertz.hpp"
#include "dem/plan.hpp"
#include "tests/dem/channel_scene.hpp"

namespace clog::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr SphereInFluid paper{.diameter = 33e-6, .density = 1062, .fluid_density = 1062, .viscosity = 1.8e-3};

TEST(Dimensionless, ReynoldsOfThePaper) {
  // 1062 x 5e-3 x 1e-4 / 1.8e-3
  EXPECT_NEAR(reynolds_number(1062, 5e-3, 1e-4, 1.8e-3), 0.295, 1e-12);
}

TEST(Dimensionless, ResponseTime) {
  // rho d^2 / (18 eta) = 1062 x 1.089e-9 / 0.0324; and that over f(0.5) = 20.515.
  EXPECT_NEAR(response_time(paper, 1.0), 3.56950e-5, 1e-9);
  EXPECT_NEAR(response_time(paper, 20.515), 1.73995e-6, 1e-10);
}

TEST(Dimensionless, SettlingOfAHeavierSphere) {
  SphereInFluid heavy = paper;
  heavy.density += 100;
  // 100 x 9.81 x 1.089e-9 / (18 x 1.8e-3 x 5e-3)
  EXPECT_NEAR(settling_ratio(heavy, 5e-3), 6.5945e-3, 1e-6);
  EXPECT_EQ(settling_ratio(paper, 5e-3), 0);
}

TEST(Dimensionless, Peclet) {
  // 5e-3 x 33e-6 x 5.5983e-7 / 4.0453e-21
  EXPECT_NEAR(peclet_number(paper, 5e-3), 2.2834e7, 1e4);
}

TEST(Dimensionless, CollisionStokes) {
  // 9.9916e-12 x 5e-4 / 2.30931e-12
  EXPECT_NEAR(collision_stokes_number(paper, 5e-4), 2.1633e-3, 1e-6);
}

TEST(Dimensionless, HertzOverlapInvertsTheForce) {
  const double modulus = 1.709e6, radius = 8.25e-6, overlap = 3e-7;
  const double force = hertz_stiffness(modulus, std::sqrt(radius * overlap)) * overlap;
  EXPECT_NEAR(hertz_overlap(force, modulus, radius), overlap, 1e-15);
}

TEST(Plan, OfThePaperNeedsNothingMore) {
  const Plan plan = make_plan(cheap_paper_scene());
  EXPECT_THAT(warnings(plan), IsEmpty());
  EXPECT_LT(plan.dt, plan.limits.smallest());
  // 0.45 x (4e-11 + 0.866e-4 x 2.5e-4 x 1e-4) m3 / 1.8817e-14 m3
  EXPECT_NEAR(plan.particles, 1008, 2);
  EXPECT_GT(plan.filling_steps, 0);
}

TEST(Plan, WarnsOfWhatIsMissing) {
  EXPECT_THAT(warnings(make_plan(cheap_paper_scene({"lubrication.enabled=false"}))),
              Contains(HasSubstr("lubrication is needed")));
  EXPECT_THAT(warnings(make_plan(cheap_paper_scene({"contact.youngs_modulus=1e5 Pa"}))),
              Contains(HasSubstr("raise contact.youngs_modulus")));
  EXPECT_THAT(warnings(make_plan(cheap_paper_scene({"time.mass_scale=1e4"}))),
              Contains(HasSubstr("lower time.mass_scale")));
  EXPECT_THAT(warnings(make_plan(cheap_paper_scene({"particles.density=1300 kg/m3"}))),
              Contains(HasSubstr("gravity is needed")));
  EXPECT_THAT(warnings(make_plan(cheap_paper_scene({"time.step_fraction=0.5"}))),
              Contains(HasSubstr("is unstable")));
}

}  // namespace
}  // namespace clog::test
