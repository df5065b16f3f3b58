// The step that a network of contacts, films and drag allows, against closed forms.
#include <gtest/gtest.h>

#include "dem/physics/laws/hertz.hpp"
#include "dem/stability/network_limit.hpp"

namespace clogflow::test {
namespace {

/// Unit sphere: mass and radius 1, a spring of its own along x.
Particles unit_spheres(int count) {
  Particles p;
  for (int k = 0; k < count; ++k) p.add({.radius = 1, .mass = 1, .inertia = 0.4});
  return p;
}

ContactModes spring(double stiffness, double dashpot) {
  ContactModes modes;
  modes.mode[modes.count++] = {stiffness, dashpot, {1, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  return modes;
}

/// Leapfrog with the damping half a step late, for one mode: does the amplitude stay bounded?
bool bounded(double stiffness, double damping, double dt) {
  double x = 1, v = 1;
  for (int k = 0; k < 20000; ++k) {
    v -= dt * (stiffness * x + damping * v);
    x += dt * v;
    if (!(std::abs(x) < 1e6)) return false;
  }
  return true;
}

TEST(StableStep, IsTheEdgeOfTheScheme) {
  for (const auto& [k, c] : {std::pair{1.0, 0.0}, {1.0, 0.5}, {1.0, 2.0}, {0.0, 1.0}, {1.0, 20.0}}) {
    const double dt = stable_step(k, c);
    EXPECT_TRUE(bounded(k, c, 0.999 * dt)) << k << " " << c;
    EXPECT_FALSE(bounded(k, c, 1.002 * dt)) << k << " " << c;
  }
  EXPECT_DOUBLE_EQ(stable_step(4, 0), 1);    // 2 / w
  EXPECT_DOUBLE_EQ(stable_step(0, 4), 0.5);  // 2 / g
}

TEST(NetworkLimit, OfOneSpringIsExact) {
  const Particles p = unit_spheres(2);
  NetworkLimit wall(p), pair(p);
  wall.add_contact(0, -1, spring(4, 0.3));
  EXPECT_NEAR(wall.bound().step, stable_step(4, 0.3), 2e-3 * stable_step(4, 0.3));
  EXPECT_EQ(wall.bound().particle, 0);
  pair.add_contact(0, 1, spring(4, 0.3));  // the reduced mass is a half
  EXPECT_NEAR(pair.bound().step, stable_step(8, 0.6), 2e-3 * stable_step(8, 0.6));
}

TEST(NetworkLimit, IsInfiniteWhenNothingTouches) {
  const Particles p = unit_spheres(1);
  EXPECT_EQ(NetworkLimit(p).bound().step, std::numeric_limits<double>::infinity());
}

TEST(NetworkLimit, OfTorsionFeelsTheMomentOfInertia) {
  // A wall, R* = r: torque 4 r^2 k w, so w^2 = 4 k r^2 / I = 10 k / m.
  const Particles p = unit_spheres(1);
  const Hertz law{.modulus = 1, .shear_modulus = 0.5, .tangential_factor = 1};
  const ContactGeometry<double> g{{0, 0, 1}, 0.01, 1, 1, 1, 0};
  NetworkLimit network(p);
  network.add_contact(0, -1, contact_modes<LudingTurning>(law, {false, false, true}, g));
  const double k = 8 * 0.5 * 0.1;
  EXPECT_NEAR(network.bound().step, 2 / std::sqrt(10 * k), 2e-3 * 2 / std::sqrt(10 * k));
}

TEST(NetworkLimit, ExplicitDragShortensTheStepAndImplicitDragLengthensIt) {
  const Particles p = unit_spheres(1);
  const auto step = [&](double drag, bool implicit) {
    NetworkLimit network(p);
    network.add_contact(0, -1, spring(4, 0));
    network.add_drag(0, {drag, 0, implicit});
    return network.bound().step;
  };
  EXPECT_LT(step(3, false), 0.8);
  EXPECT_GT(step(3, true), 1.5);
}

TEST(NetworkLimit, ExactIsThatOfTheWholeChain) {
  // n unit masses in a row, springs k between them: w^2 = 2 k (1 + cos(pi / n)); the bound says 4 k.
  for (const int n : {2, 3, 8}) {
    const Particles p = unit_spheres(n);
    NetworkLimit chain(p);
    for (int i = 0; i + 1 < n; ++i) chain.add_contact(i + (i % 2), i + 1 - (i % 2), spring(4, 0));
    const double limit = 2 / std::sqrt(8 * (1 + std::cos(M_PI / n)));
    const auto bound = chain.bound();
    EXPECT_LE(bound.step, 1.001 * limit) << n;
    EXPECT_NEAR(chain.exact(bound), limit, 0.01 * limit) << n;
  }
}

TEST(NetworkLimit, ExactOfManyIsSafeWithoutASearchOfAllModes) {
  // 400 masses have many frequencies close to the highest: the worst there is for Lanczos' method. 2 % are promised.
  constexpr int n = 400;
  const Particles p = unit_spheres(n);
  for (const double dashpot : {0.0, 0.5}) {
    NetworkLimit chain(p);
    for (int i = 0; i + 1 < n; ++i) chain.add_contact(i, i + 1, spring(4, dashpot));
    const double modes = 2 * (1 + std::cos(M_PI / n)), limit = stable_step(4 * modes, dashpot * modes);
    const double found = chain.exact(chain.bound());
    EXPECT_LE(found, limit) << dashpot;
    EXPECT_GE(found, 0.98 * limit) << dashpot;
  }
}

TEST(NetworkLimit, ExactIsInfiniteWhereImplicitDragHoldsAllFilms) {
  const Particles p = unit_spheres(3);
  const auto limit = [&](double drag) {
    NetworkLimit network(p);
    network.add_film(0, 1, {1, 0, 0}, 1);
    network.add_film(1, 2, {1, 0, 0}, 1);
    for (const int i : {0, 1, 2}) network.add_drag(i, {drag, 0, true});
    return network.exact(network.bound());
  };
  // The fastest of the chain's modes is damped by 3: 4 + 2 drag dt = 2 * 3 dt has no solution beyond drag = 3.
  EXPECT_EQ(limit(3.5), std::numeric_limits<double>::infinity());
  EXPECT_LE(limit(2), 2);
  EXPECT_GE(limit(2), 1.9);
}

TEST(NetworkLimit, ExactKnowsDashpotsAndDrag) {
  const Particles p = unit_spheres(2);
  for (const bool implicit : {false, true}) {
    NetworkLimit network(p);
    network.add_contact(0, 1, spring(4, 0.3));
    for (const int i : {0, 1}) network.add_drag(i, {0.7, 0, implicit});
    // The pair's mode is that of one mass: k dt^2 + 2 c dt -+ 2 drag dt = 4.
    const double c = 0.6 + (implicit ? -0.7 : 0.7), limit = (-c + std::sqrt(c * c + 4 * 8)) / 8;
    EXPECT_NEAR(network.exact(network.bound()), limit, 0.01 * limit) << implicit;
  }
}

}  // namespace
}  // namespace clogflow::test
