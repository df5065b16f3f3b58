// Drag, lubrication, porosity and characteristic times: values worked out by hand.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "dem/fluid/porosity_strips.hpp"
#include "dem/physics/drag_law.hpp"
#include "dem/physics/lubrication.hpp"
#include "dem/physics/porosity.hpp"
#include "dem/physics/time_step.hpp"

namespace clogflow {
namespace {

constexpr double pi = std::numbers::pi;

TEST(VoidageFunction, HasTheValuesWorkedOutFromThePaper) {
  const DragLaw& hoef = find_drag_law("hoef");
  // Half of the last digit printed.
  EXPECT_NEAR(hoef.slow_factor(0.6), 11.81, 0.005);
  EXPECT_NEAR(hoef.slow_factor(0.5), 20.515, 0.0005);
  EXPECT_NEAR(hoef.slow_factor(0.4), 37.85, 0.01);
  EXPECT_NEAR(hoef.slow_factor(0.36), 49.67, 0.005);
  EXPECT_EQ(hoef.slow_factor(1.0), 1.0);
  // To the last digit: 10 * 0.5 / 0.25 + 0.25 (1 + 1.5 sqrt 0.5)
  EXPECT_DOUBLE_EQ(hoef.slow_factor(0.5), 20 + 0.25 + 0.375 * std::sqrt(0.5));
}

TEST(Stokes, OfAPaperParticle) {
  // 3 pi * 1.8e-3 * 33e-6 = 5.598318e-7 N s/m; pi * 1.8e-3 * (33e-6)^3 = 2.032189e-16 N m s
  EXPECT_NEAR(stokes_coefficient(1.8e-3, 33e-6), 5.598318e-7, 1e-13);
  EXPECT_NEAR(stokes_torque_coefficient(1.8e-3, 33e-6), 2.032189e-16, 1e-22);
}

TEST(ImplicitDrag, NeverOvershoots) {
  EXPECT_EQ(implicit_drag_factor(0.0), 1.0);
  // v + dt c/m (u - v) share stays between v and u however stiff.
  for (const double rate : {1e-3, 1.0, 10.0, 1e6}) EXPECT_LT(rate * implicit_drag_factor(rate), 1);
}

TEST(Lubrication, OfEqualSpheresIsThePaperEquation3) {
  const double eta = 1.8e-3, d = 33e-6, h = 1e-6;
  EXPECT_DOUBLE_EQ(lubrication_coefficient(eta, d / 4, h), 3 * pi * eta * d * d / (8 * h));
  // Hand: 3 pi * 1.8e-3 * 1.089e-9 / 8e-6 = 2.309306e-6 N s/m
  EXPECT_NEAR(lubrication_coefficient(eta, d / 4, h), 2.309306e-6, 1e-12);
}

TEST(Lubrication, ReachesInProportionToUnequalSpheres) {
  LubricationLaw law{.viscosity = 1, .nearest = 0.01, .farthest = 0.5};
  EXPECT_EQ(law.reach(7.0), 0.5);
  // Two spheres of d = 1 have R* = 1/4 and reach d / 2; of d = 2 twice as far.
  law.per_radius = 2;
  EXPECT_EQ(film_coefficient(law, 0.25, 0.501, 1.0), 0);
  EXPECT_NEAR(film_coefficient(law, 0.25, 0.499, 1.0), 6 * pi * 0.0625 / 0.499, 1e-12);
  EXPECT_GT(film_coefficient(law, 0.5, 0.999, 1.0), 0);
  EXPECT_EQ(film_coefficient(law, 0.5, 1.001, 1.0), 0);
}

TEST(HertzContactTime, OfThePaper) {
  // E* = 3e9 / (2 (1 - 0.35^2)) = 1.7094017e9 Pa, rho / E* = 6.21270e-7, to the power 0.4 3.29093e-3;
  // 2.214 * 3.29093e-3 * 33e-6 / (5e-4)^0.2 (= 0.218672) = 1.09955e-6 s
  const double time = hertz_contact_time({1062, 3e9 / (2 * 0.8775), 33e-6, 0.1 * 5e-3});
  EXPECT_NEAR(time, 1.1e-6, 0.05e-6);
  EXPECT_NEAR(time, 1.09955e-6, 0.0001e-6);
  EXPECT_DOUBLE_EQ(collision_speed_share, 0.1);
}

TEST(HertzContactTime, IsHertzsOwn) {
  // 2.943 (5 sqrt 2 pi rho / (4 E))^(2/5) r / v^(1/5) with E / (1 - nu^2) = 2 E*: the textbook's
  // duration for a sphere of radius r against its mirror image, relative speed v. The paper's 2.214
  // rounds 2.87 (m*^2 / (R* E*^2 v))^(1/5), so agreement is to the digits of 2.87.
  const double rho = 2800, modulus = 25e9, r = 0.01, v = 20;
  const double mass = rho * 4.0 / 3 * pi * r * r * r / 2;
  const double hertz = 2.87 * std::pow(mass * mass / (r / 2 * modulus * modulus * v), 0.2);
  EXPECT_NEAR(hertz_contact_time({rho, modulus, 2 * r, v}) / hertz, 1, 0.005);
}

TEST(RayleighTime, OfGlass) {
  // pi * 0.01 * sqrt(2800 / 20e9) / (0.1631 * 0.2 + 0.8766) = 1.17548e-5 / 0.90922
  EXPECT_NEAR(rayleigh_time(0.01, 2800, 20e9, 0.2), 1.2929e-5, 1e-9);
}

TEST(SphereVolume, CutByAPlane) {
  const double whole = 4.0 / 3 * pi;
  EXPECT_DOUBLE_EQ(sphere_volume(1), whole);
  EXPECT_DOUBLE_EQ(sphere_volume_below(0, 1, 0), whole / 2);
  EXPECT_DOUBLE_EQ(sphere_volume_below(0, 1, 5), whole);
  EXPECT_NEAR(sphere_volume_below(0, 1, -5), 0, 1e-15);
  // A cap of height 1/2: pi h^2 (3 - h) / 3 = pi 0.25 * 2.5 / 3 = 5 pi / 24
  EXPECT_NEAR(sphere_volume_below(0, 1, -0.5), 5 * pi / 24, 1e-15);
  // Moved and scaled: volumes go with the cube.
  EXPECT_NEAR(sphere_volume_below(7, 2, 6), 8 * 5 * pi / 24, 1e-14);
}

Particles spheres(const std::vector<std::array<double, 2>>& places_and_radii) {
  Particles p;
  for (const auto& [x, r] : places_and_radii) {
    Particle particle;
    particle.id = static_cast<std::int64_t>(p.size());
    particle.x = x, particle.radius = r;
    p.add(particle);
  }
  return p;
}

TEST(PorosityStrips, CutSpheresExactly) {
  // Three strips of length 1 and volume 10 on [0, 3]: a sphere on the first edge, one inside, one
  // across both edges of the middle strip.
  PorosityStrips strips(0, 3, {10, 10, 10});
  strips.update(spheres({{1.0, 0.4}, {2.5, 0.3}, {1.5, 0.9}}));
  const double across = sphere_volume_below(1.5, 0.9, 1);
  EXPECT_NEAR(strips.porosity()[0], 1 - (sphere_volume(0.4) / 2 + across) / 10, 1e-14);
  EXPECT_NEAR(strips.porosity()[1], 1 - (sphere_volume(0.4) / 2 + sphere_volume(0.9) - 2 * across) / 10, 1e-14);
  EXPECT_NEAR(strips.porosity()[2], 1 - (sphere_volume(0.3) + across) / 10, 1e-14);
}

TEST(PorosityStrips, LoseNothingBetweenThem) {
  // Whatever the cuts, the solid of all strips is that of the spheres.
  for (const int count : {1, 2, 3, 7, 40}) {
    PorosityStrips strips(-2, 5, std::vector<double>(count, 100.0 / count));
    strips.update(spheres({{-1, 0.9}, {0.03, 0.5}, {2.2, 1.3}, {4, 1}}));
    EXPECT_NEAR(strips.packing_fraction() * 100,
                sphere_volume(0.9) + sphere_volume(0.5) + sphere_volume(1.3) + sphere_volume(1), 1e-12)
        << count;
  }
}

TEST(PorosityStrips, CountOnlyWhatIsBetweenTheEnds) {
  PorosityStrips strips(0, 2, {10, 10});
  strips.update(spheres({{0, 0.5}, {2, 0.5}, {-3, 1}, {9, 1}}));
  EXPECT_NEAR(strips.packing_fraction() * 20, sphere_volume(0.5), 1e-14);
  EXPECT_EQ(strips.strip_at(-1), 0);
  EXPECT_EQ(strips.strip_at(0.999), 0);
  EXPECT_EQ(strips.strip_at(1.0), 1);
  EXPECT_EQ(strips.strip_at(77), 1);
}

TEST(PorosityStrips, DoNotFlipWhenASphereCrossesAnEdge) {
  PorosityStrips strips(0, 2, {10, 10});
  strips.update(spheres({{1 - 1e-9, 0.5}}));
  const double before = strips.porosity()[0];
  strips.update(spheres({{1 + 1e-9, 0.5}}));
  // The disc of radius 0.5 times the way: 2e-9 * 0.785 / 10.
  EXPECT_NEAR(strips.porosity()[0] - before, 2e-9 * pi / 4 / 10, 1e-14);
}

}  // namespace
}  // namespace clogflow
