// Films taken implicitly: the same law as the explicit ones, at any step.
#include <gmock/gmock.h>

#include "dem/physics/lubrication.hpp"
#include "dem/stability/step_limit.hpp"
#include "tests/coupling/refusal.hpp"
#include "tests/dem/laboratory.hpp"

namespace clogflow::test {
namespace {

using testing::HasSubstr;

constexpr double eta = 1.8e-3, d = 33e-6, rho = 1062;

double mass() { return rho * M_PI / 6 * d * d * d; }

Scene film_scene(double step, Integrator integrator = Integrator::implicit_fluid) {
  Scene s = laboratory_scene({3e6, 0.35, rho, d}, step);
  s.fluid.viscosity = eta;
  s.lubrication.enabled = true;
  s.lubrication.cutoff = d / 2;
  s.time.integrator = integrator;
  return s;
}

/// A chain of spheres 1 um apart that move at random, on a floor with a film too.
std::vector<Particle> chain(int count) {
  std::vector<Particle> all;
  for (int k = 0; k < count; ++k)
    all.push_back({.radius = d / 2,
                   .x = k * (d + 1e-6),
                   .y = 0.1 * d * std::cos(7.0 * k),
                   .z = d / 2 + 1e-6,
                   .vx = 1e-2 * std::sin(3.0 * k),
                   .vy = 1e-2 * std::sin(5.0 * k),
                   .vz = 1e-2 * std::cos(2.0 * k)});
  return all;
}

Scene chain_scene(double step, Integrator integrator = Integrator::implicit_fluid) {
  Scene s = film_scene(step, integrator);
  s.lubrication.walls = true;
  s.lubrication.below_roughness = BelowRoughness::clamp;
  set_floor(s, 100 * d);
  return s;
}

/// Largest step of the explicit film of two spheres with the gap h: 2 m* / c.
double explicit_limit(double h) { return mass() / lubrication_coefficient(eta, d / 4, h); }

TEST(ImplicitFilms, TendToTheExplicitForceAsTheStepFalls) {
  Laboratory implicit(chain_scene(1e-16), chain(8)), explicit_(chain_scene(1e-16, Integrator::verlet), chain(8));
  implicit->compute_forces(), explicit_->compute_forces();
  for (int k = 0; k < 8; ++k) {
    ASSERT_GT(explicit_.force(k).norm(), 0);
    // The first order in the step: dt c / m is 1e-8.
    EXPECT_LT((implicit.force(k) - explicit_.force(k)).norm(), 1e-6 * explicit_.force(k).norm()) << k;
  }
}

TEST(ImplicitFilms, SolveTheBackwardStep) {
  // One film along x: v' of the approach is v / (1 + dt c / m*), whatever the step; the common
  // motion stays.
  const double h = 1e-6, c = lubrication_coefficient(eta, d / 4, h);
  for (const double step : {1e-9, 1e-7, 1e-5, 1e-3}) {
    Scene s = film_scene(step);
    Laboratory lab(s, {{.radius = d / 2, .vx = 2e-3}, {.radius = d / 2, .x = d + h, .vx = -1e-3}});
    lab->compute_forces();
    lab->advance();
    const double kick = step / 2, expected = 3e-3 / (1 + kick * c / (mass() / 2));
    EXPECT_NEAR((lab.velocity(0) - lab.velocity(1)).x, expected, 1e-9 * 3e-3) << step;
    EXPECT_NEAR((lab.velocity(0) + lab.velocity(1)).x, 1e-3, 1e-14) << step;
  }
}

TEST(ImplicitFilms, SolveDragAndFilmsTogether) {
  // A sphere over a floor, pushed by body force and flow: (m + dt (c_d + c_w)) v' = dt (F + c_d u).
  const double h = 1e-6, step = 1e-5, wall = lubrication_coefficient(eta, d / 2, h), drag = 3 * M_PI * eta * d;
  Scene s = film_scene(step);
  s.lubrication.walls = true;
  set_floor(s, 100 * d);
  s.drag.enabled = true;
  s.flow.source = FlowSource::uniform;
  s.flow.velocity = {0, 0, -5e-3};
  s.body_force = {0, 0, -1e-9};
  Laboratory lab(s, {{.radius = d / 2, .z = d / 2 + h}});
  lab->compute_forces();
  lab->advance();
  const double kick = step / 2;
  EXPECT_NEAR(lab.velocity(0).z / (kick * (-1e-9 - drag * 5e-3) / (mass() + kick * (wall + drag))), 1, 1e-7);
}

/// A sphere pressed on a floor by the force F through its film, inertia gone: h = h0 exp(-F t / a),
/// a = 6 pi eta r^2. The gap after the time that brings it to h0 / e.
double pressed_gap(Integrator integrator, double steps) {
  const double h0 = 4e-6, force = 2e-11, a = 6 * M_PI * eta * d * d / 4, time = a / force;
  Scene s = film_scene(time / steps, integrator);
  s.lubrication.walls = true;
  set_floor(s, 100 * d);
  s.body_force = {0, 0, -force};
  Laboratory lab(s, {{.radius = d / 2, .z = d / 2 + h0, .vz = -force * h0 / a}});
  for (int k = 0; k < steps; ++k) lab.step();
  return (lab.position(0).z - d / 2) / h0;
}

TEST(ImplicitFilms, FollowTheClosedFormFarAboveTheExplicitLimit) {
  const double steps = 200, a = 6 * M_PI * eta * d * d / 4;
  ASSERT_GT(a / 2e-11 / steps, 100 * 2 * mass() / (a / 4e-6));
  EXPECT_NEAR(pressed_gap(Integrator::implicit_fluid, steps), std::exp(-1.0), 2.0 / steps);
  EXPECT_ANY_THROW(pressed_gap(Integrator::implicit_drag, steps)) << "this step must be too large without";
}

TEST(ImplicitFilms, NeverAddEnergyAndKeepMomentumAtAnyStep) {
  for (const double times : {0.5, 10.0, 1e4}) {
    Scene s = film_scene(times * explicit_limit(1e-6));
    s.lubrication.below_roughness = BelowRoughness::clamp;
    std::vector<Particle> spheres = chain(12);
    // So slow that nothing touches in the steps that follow.
    const double slow = 1e-9 / s.time.step / 1e-2;
    for (Particle& p : spheres) p.vx *= slow, p.vy *= slow, p.vz *= slow;
    Laboratory lab(s, spheres);
    const auto momentum = [&] {
      Vec3 sum = Vec3::Zero();
      for (int k = 0; k < 12; ++k) sum += lab.velocity(k);
      return sum;
    };
    const Vec3 before = momentum();
    double energy = lab->kinetic_energy();
    for (int k = 0; k < 20; ++k) {
      lab.step();
      double now = 0;
      for (int i = 0; i < 12; ++i) now += 0.5 * mass() * lab.velocity(i).squaredNorm();
      EXPECT_LT(now, energy * (1 + 1e-12)) << times << " " << k;
      energy = now;
    }
    EXPECT_LT((momentum() - before).norm(), 1e-13 * 12 * 1e-2 * slow) << times;
  }
}

TEST(ImplicitFilms, DoNotLimitTheStep) {
  const std::vector<Particle> two{{.radius = d / 2}, {.radius = d / 2, .x = d + 1e-6}};
  const auto limits = [&](Integrator integrator) {
    const Scene s = film_scene(1e-8, integrator);
    const Model model = make_model(s, nullptr, two);
    Laboratory lab(s, two);
    lab->compute_forces();
    return std::pair{expected_limits(model, two), lab->network().bound().step};
  };
  const auto [expected, network] = limits(Integrator::implicit_fluid);
  EXPECT_TRUE(std::isinf(expected.lubrication));
  EXPECT_TRUE(std::isinf(network));
  EXPECT_THAT(limit_words(expected, 1e-8), HasSubstr("dt/lubrication limit 0,"));
  const auto [finite, film] = limits(Integrator::implicit_drag);
  EXPECT_LT(finite.lubrication, 1e-5);
  EXPECT_NEAR(film, explicit_limit(1e-6), 2e-3 * film);
  Scene s = film_scene(1e-3, Integrator::implicit_drag);
  const Model model = make_model(s, nullptr, two);
  EXPECT_THAT(refusal([&] { check_step(expected_limits(model, two), model); }), HasSubstr("implicit_fluid"));
}

TEST(ImplicitFilms, WithAWallLimitAnExplicitStep) {
  Scene s = film_scene(1e-8, Integrator::verlet);
  s.lubrication.walls = true;
  set_floor(s, 100 * d);
  Laboratory lab(s, {{.radius = d / 2, .z = d / 2 + 1e-6}});
  lab->compute_forces();
  const double limit = 2 * mass() / lubrication_coefficient(eta, d / 2, 1e-6);
  EXPECT_NEAR(lab->network().bound().step, limit, 2e-3 * limit);
}

TEST(ImplicitFilms, ThatCannotBeSolvedForAreAnError) {
  Scene s = film_scene(0.5);
  s.fluid.viscosity = 1e6;
  Laboratory lab(s, chain(20));
  EXPECT_THAT(refusal([&] { lab->compute_forces(); }), HasSubstr("the fluid films could not be solved for"));
}

TEST(ImplicitFilms, LeaveANaNToTheStepThatNamesIt) {
  Laboratory lab(film_scene(1e-8), chain(3));
  lab->particles()[1].vy = std::nan("");
  EXPECT_THAT(refusal([&] { lab.step(); }), HasSubstr("particle 1 "));
}

}  // namespace
}  // namespace clogflow::test
