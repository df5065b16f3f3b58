// The trials of the stability map against a chain whose limit follows by hand.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/dem/laboratory.hpp"
#include "trade/step_trials.hpp"

namespace clogflow::test {
namespace {

constexpr double modulus = 1e9, poisson = 0.35, density = 2500, fall = 1e-3;  // [Pa], [-], [kg/m3], [m/s2]

double mass_of(double radius) { return density * 4 / 3 * M_PI * std::pow(radius, 3); }

constexpr double own = modulus / (2 * (1 - poisson * poisson));  // E* [Pa]

/// Of a Hertz contact under a load [m]
double overlap(double load, double radius) { return std::pow(3 * load / (4 * own * std::sqrt(radius)), 2.0 / 3); }

/// Its tangent: 2 E* sqrt(R* delta) [N/m]
double tangent(double load, double radius) { return 2 * own * std::sqrt(radius * overlap(load, radius)); }

/// One sphere on a floor and one on top of it, smooth and elastic, pressed by weights so small that the upper one does
/// not fall off while it is watched.
class Chain : public Column {
public:
  Chain(double below, double above) : below_(below), above_(above) {}

  /// 2 / omega of the faster of its two modes along the axis [s]
  double limit_by_hand() const {
    const double m = mass_of(below_), n = mass_of(above_);
    const double floor = tangent((m + n) * fall, below_), between = tangent(n * fall, effective());
    const double a = (floor + between) / m, b = between / n, c = between / std::sqrt(m * n);
    return 2 / std::sqrt((a + b) / 2 + std::sqrt((a - b) * (a - b) / 4 + c * c));
  }

  double diameter() const override { return 2 * below_; }

  Simulation simulation(double step) const override {
    Scene scene = laboratory_scene({modulus, poisson, density, 2 * below_}, step);
    set_floor(scene, 20 * std::max(below_, above_));
    scene.gravity = {0, 0, -fall};
    // Close to rest: nine tenths of the overlaps.
    const double z = below_ - 0.9 * overlap((mass_of(below_) + mass_of(above_)) * fall, below_);
    const double next = z + below_ + above_ - 0.9 * overlap(mass_of(above_) * fall, effective());
    return Simulation(scene, nullptr, 1, {{.radius = below_, .z = z}, {.radius = above_, .z = next}});
  }

private:
  double effective() const { return below_ * above_ / (below_ + above_); }

  double below_, above_;
};

/// \param tolerance  of the measured limit [-]
void expect_limit(const Column& column, double limit, double tolerance) {
  StepVerdict found;
  found.step = 0.05 * limit, found.expected = limit;
  try_steps(column, found);
  EXPECT_TRUE(found.at_rest);
  // The search for the largest eigenvalue and the bisection stop at 1 % each.
  EXPECT_NEAR(found.predicted, limit, 0.02 * limit);
  EXPECT_NEAR(found.measured, limit, tolerance * limit);
}

void expect_limit_by_hand(double below, double above) {
  const Chain chain(below, above);
  // Nothing damps: at 0.95 of its limit a mode swings with ten times the energy of the push, 1 / (1 - 0.95^2).
  expect_limit(chain, chain.limit_by_hand(), 0.06);
}

TEST(StepTrials, FindTheLimitOfAChainByHand) { expect_limit_by_hand(1e-3, 1e-3); }

TEST(StepTrials, FindItWhereALightSphereBearsAHeavyOne) { expect_limit_by_hand(1e-3, 2e-3); }

TEST(StepTrials, FindItWhereAHeavySphereBearsALightOne) { expect_limit_by_hand(3e-3, 0.5e-3); }

/// Two smooth spheres side by side on a floor, a film of liquid between them, no drag.
class Neighbours : public Column {
public:
  static constexpr double radius = 1e-3, gap = 5e-5, viscosity = 100;  // [m], [m], [Pa s]

  /// m / c: the film's rate on the velocity of approach is 2 c / m, and a step reverses it at most [s]
  double limit_by_hand() const { return mass_of(radius) / (6 * M_PI * viscosity * radius * radius / 4 / gap); }

  double diameter() const override { return 2 * radius; }

  Simulation simulation(double step) const override {
    Scene scene = laboratory_scene({modulus, poisson, density, 2 * radius}, step);
    set_floor(scene, 20 * radius);
    scene.gravity = {0, 0, -fall};
    scene.fluid.viscosity = viscosity;
    scene.particles.roughness = 1e-5;
    scene.lubrication.enabled = true;
    scene.lubrication.cutoff = radius;
    const double far = radius + gap / 2;
    return Simulation(scene, nullptr, 1,
                      {{.radius = radius, .x = -far, .z = radius}, {.radius = radius, .x = far, .z = radius}});
  }
};

TEST(StepTrials, FindTheLimitOfAFilmByHand) {
  const Neighbours pair;
  expect_limit(pair, pair.limit_by_hand(), 0.03);
}

}  // namespace
}  // namespace clogflow::test
