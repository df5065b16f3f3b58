// Spheres in a fluid: terminal velocity, relaxation, and two spheres squeezed together.
#include <gtest/gtest.h>

#include "dem/physics/drag.hpp"
#include "dem/physics/lubrication.hpp"
#include "tests/dem/laboratory.hpp"

namespace clogflow::test {
namespace {

constexpr double eta = 1.8e-3, d = 33e-6, rho = 1062;

double mass() { return rho * M_PI / 6 * d * d * d; }

Scene fluid_scene(double step) {
  Scene s = laboratory_scene({3e6, 0.35, rho, d}, step);
  s.fluid.viscosity = eta;
  s.fluid.density = rho;
  return s;
}

Scene drag_scene(double step) {
  Scene s = fluid_scene(step);
  s.drag.enabled = true;
  s.flow.source = FlowSource::uniform;
  s.flow.velocity = {5e-3, -1e-3, 0};
  return s;
}

TEST(Drag, LeadsToTheTerminalVelocity) {
  for (const Integrator integrator : {Integrator::verlet, Integrator::implicit_drag}) {
    Scene s = drag_scene(1e-6);
    s.body_force = {0, 0, -2e-12};
    s.time.integrator = integrator;
    Laboratory lab(s, {{.radius = d / 2}});
    const double c = 3 * M_PI * eta * d;
    lab.run_until(30 * mass() / c);
    EXPECT_NEAR(lab.velocity(0).x, 5e-3, 1e-12);
    EXPECT_NEAR(lab.velocity(0).y, -1e-3, 1e-12);
    EXPECT_NEAR(lab.velocity(0).z, -2e-12 / c, 1e-12);
  }
}

TEST(Drag, RelaxesExponentially) {
  // Response time m / c = 3.57e-5 s; a leapfrog of 1000 steps per response time.
  const double c = 3 * M_PI * eta * d, response = mass() / c;
  Laboratory lab(drag_scene(response / 1000), {{.radius = d / 2}});
  lab.run_until(response);
  EXPECT_NEAR(lab.velocity(0).x, 5e-3 * (1 - std::exp(-1.0)), 5e-3 * 1e-3);
}

TEST(Drag, ImplicitIsStableAtAnyStep) {
  Scene s = drag_scene(1e-2);  // 300 response times
  s.flow.velocity = {1e-5, 0, 0};
  s.time.integrator = Integrator::implicit_drag;
  Laboratory lab(s, {{.radius = d / 2}});
  for (int k = 0; k < 20; ++k) {
    lab.step();
    EXPECT_GE(lab.velocity(0).x, 0);
    EXPECT_LE(lab.velocity(0).x, 1e-5 * (1 + 1e-12));
  }
}

TEST(Drag, TurnsASphereWithTheViscousTorque) {
  // Spin decays with I / (pi eta d^3) in a fluid that does not turn.
  Scene s = drag_scene(1e-8);
  s.drag.viscous_torque = true;
  Laboratory lab(s, {{.radius = d / 2, .wz = 100}});
  const double time = 0.4 * mass() * d * d / 4 / (M_PI * eta * d * d * d);
  lab.run_until(time);
  EXPECT_NEAR(lab.spin(0).z, 100 * std::exp(-1.0), 0.1);
}

/// Two equal spheres with the gap h that approach each other at speed v: the force on the second.
double film_force(const Scene& s, double h, double v) {
  Laboratory lab(s, {{.radius = d / 2, .vx = v / 2}, {.radius = d / 2, .x = d + h, .vx = -v / 2}});
  lab->compute_forces();
  EXPECT_NEAR((lab.force(0) + lab.force(1)).norm(), 0, 1e-25);
  return lab.force(1).x;
}

Scene film_scene() {
  Scene s = fluid_scene(1e-8);
  s.lubrication.enabled = true;
  s.lubrication.cutoff = d / 2;
  return s;
}

TEST(Lubrication, IsThePapersEquation3InItsRange) {
  const double xi = 0.005 * d, v = 1e-3;
  for (const double h : {2.001 * xi, 1e-6, 5e-6, 0.499 * d}) {
    const double expected = 3 * M_PI * eta * d * d / (8 * h) * v;
    // The gap is a difference of lengths 1e2 times larger, at rounding.
    EXPECT_NEAR(film_force(film_scene(), h, v) / expected, 1, 1e-12) << h;
    EXPECT_NEAR(film_force(film_scene(), h, -v) / expected, -1, 1e-12) << h;
  }
}

TEST(Lubrication, IsAbsentBelowTwiceTheRoughnessAndBeyondTheCutoff) {
  const double xi = 0.005 * d;
  for (const double h : {0.01 * xi, 1.999 * xi, 0.501 * d, 0.7 * d})
    EXPECT_EQ(film_force(film_scene(), h, 1e-3), 0) << h;
}

TEST(Lubrication, ClampedIsHeldBelowTwiceTheRoughness) {
  Scene s = film_scene();
  s.lubrication.below_roughness = BelowRoughness::clamp;
  const double xi = 0.005 * d, held = 3 * M_PI * eta * d * d / (8 * 2 * xi) * 1e-3;
  for (const double h : {0.01 * xi, xi, 1.999 * xi}) EXPECT_NEAR(film_force(s, h, 1e-3) / held, 1, 1e-12) << h;
}

TEST(Lubrication, OpposesOnlyTheMotionAlongTheLineOfCentres) {
  Laboratory lab(film_scene(), {{.radius = d / 2, .vy = 1e-3, .wz = 50}, {.radius = d / 2, .x = d + 1e-6}});
  lab->compute_forces();
  EXPECT_EQ(lab.force(0).norm(), 0);
}

TEST(Lubrication, OfUnequalSpheresUsesTheEffectiveRadius) {
  Laboratory lab(film_scene(), {{.radius = d / 2, .vx = 1e-3}, {.radius = d / 4, .x = 0.75 * d + 1e-6}});
  lab->compute_forces();
  // R* = d/6: 6 pi eta (d/6)^2 / h
  EXPECT_NEAR(lab.force(1).x / (M_PI * eta * d * d / 6 / 1e-6 * 1e-3), 1, 1e-12);
}

TEST(Lubrication, SqueezedSpheresFollowTheClosedForm) {
  // Two free spheres, m* = m/2: m* dv/dt = -a v / h, dh/dt = -v, so v = v0 - (a/m*) ln(h0/h).
  const double a = 3 * M_PI * eta * d * d / 8, reduced = mass() / 2, h0 = 5e-6, v0 = 0.05;
  Scene s = film_scene();
  s.time.step = 1e-9;
  Laboratory lab(s, {{.radius = d / 2, .vx = v0 / 2}, {.radius = d / 2, .x = d + h0, .vx = -v0 / 2}});
  const double stop = h0 * std::exp(-v0 * reduced / a);  // the gap at which they would stand
  ASSERT_GT(stop, 2 * 0.005 * d) << "the closed form ends where the film does";
  for (int k = 0; k < 40000; ++k) lab.step();
  const double h = (lab.position(1) - lab.position(0)).x - d;
  const double v = -(lab.velocity(1) - lab.velocity(0)).x;
  EXPECT_LT(h, 0.9 * h0);
  EXPECT_NEAR(v, v0 - a / reduced * std::log(h0 / h), 1e-3 * v0);
}

TEST(Lubrication, WithAWallActsOnlyWhenAsked) {
  for (const bool walls : {false, true}) {
    Scene s = film_scene();
    s.lubrication.walls = walls;
    set_floor(s, 20 * d);
    Laboratory lab(s, {{.radius = d / 2, .z = d / 2 + 1e-6, .vz = -1e-3}});
    lab->compute_forces();
    // R* = r = d/2: 6 pi eta d^2 / (4 h)
    const double expected = walls ? 1.5 * M_PI * eta * d * d / 1e-6 * 1e-3 : 0;
    EXPECT_NEAR(lab.force(0).z, expected, 1e-12 * expected);
  }
}

}  // namespace
}  // namespace clogflow::test
