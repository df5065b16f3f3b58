// Random factors on the flow: the numbers behind them, their closed forms, and the force they make.
#include <cmath>

#include <gtest/gtest.h>

#include "coupling/base/philox.hpp"
#include "dem/fluid/fluid_noise.hpp"
#include "dem/physics/drag.hpp"
#include "dem/physics/ornstein_uhlenbeck.hpp"
#include "dem/state/normal_numbers.hpp"
#include "tests/dem/laboratory.hpp"

namespace clogflow::test {
namespace {

// The three vectors that the authors of Philox publish with their library (kat_vectors).
TEST(CounterRandom, PhiloxGivesThePublishedWords) {
  using Words = std::array<std::uint32_t, 4>;
  constexpr std::uint32_t ones = 0xffffffff;
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}), (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox({ones, ones, ones, ones}, {ones, ones}), (Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(CounterRandom, NormalNumbersHaveTheMomentsOfTheNormalLaw) {
  constexpr int count = 100000;
  double mean = 0, square = 0, fourth = 0, product = 0;
  for (int k = 0; k < count; ++k) {
    const auto n = normal_numbers({.seed = 7, .stream = 2, .draw = 5, .owner = k});
    for (double v : n) mean += v, square += v * v, fourth += v * v * v * v;
    product += n[0] * n[1] + n[1] * n[2] + n[0] * n[2];
  }
  const double samples = 3.0 * count;
  // Five standard errors: those of the moments are 1, sqrt(2), sqrt(96) and 1 over sqrt(samples).
  const double error = 5 / std::sqrt(samples);
  EXPECT_NEAR(mean / samples, 0, error);
  EXPECT_NEAR(square / samples, 1, std::sqrt(2) * error);
  EXPECT_NEAR(fourth / samples, 3, std::sqrt(96) * error);
  EXPECT_NEAR(product / samples, 0, error);
}

Scene noisy_scene(double fluctuation, double pulsation) {
  Scene scene = laboratory_scene({.density = 1000, .diameter = 1e-4}, 1e-5);
  scene.fluid.viscosity = 1e-3, scene.fluid.density = 1000;
  scene.drag.enabled = true;
  scene.flow.source = FlowSource::uniform;
  scene.flow.velocity = {1e-3, 0, 0};
  scene.drag.fluctuation.strength = fluctuation, scene.drag.fluctuation.time = 2e-3;
  scene.flow.pulsation.strength = pulsation, scene.flow.pulsation.time = 2e-3;
  return scene;
}

Particles crowd(int count) {
  Particles particles;
  for (int k = 0; k < count; ++k) {
    Particle particle;
    particle.id = 3 * k;
    particles.add(particle);
  }
  return particles;
}

// <xi(0) xi(t)> = exp(-t / T), at the beginning (a stationary start) and later, the three components
// and the particles independent of each other.
TEST(FluidNoise, FluctuationHasItsClosedFormVarianceAndCorrelation) {
  constexpr int count = 20000;
  constexpr double strength = 0.7;
  const Particles particles = crowd(count);
  for (const double longest_step : {1e-5, 1.3e-3}) {  // a fraction of the interval T/100, many of them
    FluidNoise noise(noisy_scene(strength, 0));
    noise.advance(particles, 11, 0);
    std::vector<std::array<double, 3>> first;
    for (int i = 0; i < count; ++i) first.push_back(noise.fluctuation(i));
    double time = 0;
    for (const double until : {0.0, 2e-4, 2e-3, 6e-3}) {
      while (time < until) noise.advance(particles, 11, time = std::min(until, time + longest_step));
      // Half an interval later: nothing has changed, and rounding does not matter.
      noise.advance(particles, 11, time + 1e-5);
      double square = 0, correlation = 0, neighbours = 0, components = 0;
      for (int i = 0; i < count; ++i) {
        const auto xi = noise.fluctuation(i), other = noise.fluctuation((i + 1) % count);
        for (int a = 0; a < 3; ++a) {
          square += xi[a] * xi[a], correlation += first[i][a] * xi[a];
          neighbours += xi[a] * other[a], components += xi[a] * xi[(a + 1) % 3];
        }
      }
      const double scale = 3.0 * count * strength * strength, error = 5 / std::sqrt(3.0 * count);
      EXPECT_NEAR(square / scale, 1, std::sqrt(2) * error) << until;
      EXPECT_NEAR(correlation / scale, std::exp(-until / 2e-3), std::sqrt(2) * error) << until;
      EXPECT_NEAR(neighbours / scale, 0, error) << until;
      EXPECT_NEAR(components / scale, 0, error) << until;
    }
  }
}

// One process over a long time: 4000 correlation times. The variance of the mean square of an
// Ornstein-Uhlenbeck process over a time t is 2 T / t.
TEST(FluidNoise, PulsationHasItsClosedFormVarianceAndCorrelation) {
  FluidNoise noise(noisy_scene(0, 0.5));
  const Particles none;
  constexpr int samples = 80000, later = 20;  // every T/20: `later` samples are one T
  std::vector<double> values;
  for (int k = 0; k < samples; ++k) {
    noise.advance(none, 5, 1e-4 * k);
    values.push_back((noise.pulsation() - 1) / 0.5);
  }
  double square = 0, correlation = 0;
  for (int k = 0; k + later < samples; ++k)
    square += values[k] * values[k], correlation += values[k] * values[k + later];
  const double error = 5 * std::sqrt(2.0 / 4000);
  EXPECT_NEAR(square / (samples - later), 1, error);
  EXPECT_NEAR(correlation / (samples - later), std::exp(-1), error);
}

TEST(FluidNoise, IsDecidedBySeedAndIdAloneNotByOrderOrCompany) {
  FluidNoise all(noisy_scene(1, 1)), few(noisy_scene(1, 1)), other_seed(noisy_scene(1, 1));
  Particles many = crowd(10), two;
  two.add({.id = 27}), two.add({.id = 6});
  for (int k = 0; k < 300; ++k) {
    all.advance(many, 1, 1e-5 * k), few.advance(two, 1, 1e-5 * k), other_seed.advance(two, 2, 1e-5 * k);
    if (k == 150) many.reorder({9, 2, 4, 1});  // and particles leave
  }
  EXPECT_EQ(few.fluctuation(0), all.fluctuation(0));
  EXPECT_EQ(few.fluctuation(1), all.fluctuation(1));
  EXPECT_EQ(few.pulsation(), all.pulsation());
  EXPECT_NE(few.fluctuation(0), other_seed.fluctuation(0));
  EXPECT_NE(few.pulsation(), other_seed.pulsation());
}

// Held still in a uniform flow: F = 3 pi eta d (u + strength min(|u - v|, |u|) xi), here |u - v| = 1.5 |u| ...
// and carried along, almost with the flow: then the slip decides.
TEST(FluidNoise, TheForceIsBoundedByTheSlipAndByTheFlow) {
  for (const auto& [speed, bound] : {std::pair{-0.5e-3, 1e-3}, {0.9e-3, 0.1e-3}}) {
    Scene scene = noisy_scene(0.3, 0);
    scene.time.integrator = Integrator::verlet;
    Particle particle;
    particle.radius = 5e-5, particle.vx = speed;
    Laboratory lab(scene, {particle});
    lab->compute_forces();
    FluidNoise noise(scene);
    noise.advance(lab->particles(), 1, 0);
    const auto xi = noise.fluctuation(0);
    lab->record();
    lab->advance();
    // The first kick takes half a step.
    const double c = stokes_coefficient(1e-3, 1e-4), rate = 5e-6 / lab->particles()[0].mass;
    EXPECT_NEAR(lab.velocity(0).x, speed + rate * c * (1e-3 - speed + bound * xi[0]), 1e-15);
    EXPECT_NEAR(lab.velocity(0).y, rate * c * bound * xi[1], 1e-15);
    EXPECT_NEAR(lab.velocity(0).z, rate * c * bound * xi[2], 1e-15);
  }
}

TEST(FluidNoise, ThePulsationScalesTheWholeFlow) {
  Scene scene = noisy_scene(0, 0.4);
  Particle particle;
  particle.radius = 5e-5;
  Laboratory lab(scene, {particle});
  lab->compute_forces();
  FluidNoise noise(scene);
  noise.advance(lab->particles(), 1, 0);
  lab->advance();
  const double c = stokes_coefficient(1e-3, 1e-4), rate = 5e-6 / lab->particles()[0].mass;
  EXPECT_NE(noise.pulsation(), 1);
  EXPECT_NEAR(lab.velocity(0).x, rate * c * 1e-3 * noise.pulsation(), 1e-15);
}

}  // namespace
}  // namespace clogflow::test
