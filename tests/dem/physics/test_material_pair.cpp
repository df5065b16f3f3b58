// Effective moduli and the dashpot constant, against numbers worked out by hand.
#include <cmath>
#include <limits>

#include <gmock/gmock.h>

#include "dem/physics/material_pair.hpp"
#include "tests/coupling/refusal.hpp"

namespace clogflow {
namespace {

using testing::HasSubstr;

TEST(EffectiveModulus, OfEqualMaterials) {
  // E / (2 (1 - nu^2)) = 3e9 / (2 * 0.8775)
  const Material paper{3e9, 0.35};
  EXPECT_NEAR(effective_modulus(paper, paper), 1.7094017094e9, 1);
  // Chung & Ooi test 1, glass: 48e9 / (2 * 0.96) = 25 GPa
  EXPECT_NEAR(effective_modulus({48e9, 0.2}, {48e9, 0.2}), 25e9, 1);
}

TEST(EffectiveModulus, OfUnequalMaterials) {
  // 1 / (0.96 / 48e9 + 0.91 / 200e9) = 1 / (2e-11 + 4.55e-12)
  EXPECT_NEAR(effective_modulus({48e9, 0.2}, {200e9, 0.3}), 1 / 2.455e-11, 10);
  EXPECT_DOUBLE_EQ(effective_modulus({48e9, 0.2}, {200e9, 0.3}), effective_modulus({200e9, 0.3}, {48e9, 0.2}));
}

TEST(EffectiveModulus, AgainstARigidWallIsThatOfTheSphereAlone) {
  // Aluminium: 70e9 / (1 - 0.33^2) = 70e9 / 0.8911 = 78.5546 GPa
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_NEAR(effective_modulus({70e9, 0.33}, {infinite, 0.33}), 70e9 / 0.8911, 1);
}

TEST(EffectiveShearModulus, OfEqualMaterials) {
  // G = 48e9 / 2.4 = 20e9, G* = G / (2 (2 - nu)) = 20e9 / 3.6
  EXPECT_NEAR(effective_shear_modulus({48e9, 0.2}, {48e9, 0.2}), 20e9 / 3.6, 1);
  // G = 3e9 / 2.7, G* = G / 3.3: a bracket in the wrong place would give 3e9 / 2 * 1.35 / 3.3.
  EXPECT_NEAR(effective_shear_modulus({3e9, 0.35}, {3e9, 0.35}), 3e9 / 2.7 / 3.3, 1);
}

TEST(EffectiveShearModulus, OfUnequalMaterials) {
  // G = 20e9 and 200e9 / 2.6: 1 / (1.8 / 20e9 + 1.7 * 2.6 / 200e9) = 1 / (9e-11 + 2.21e-11)
  EXPECT_NEAR(effective_shear_modulus({48e9, 0.2}, {200e9, 0.3}), 1 / 1.121e-10, 10);
}

TEST(MindlinOverHertz, IsTheRatioOfTheTextbook) {
  // k_t / k_n (tangents) = 8 G* / (2 E*) = 2 (1 - nu) / (2 - nu) for equal materials, Johnson (7.44)
  for (const double nu : {0.0, 0.2, 0.35, 0.49}) {
    const Material m{1e9, nu};
    EXPECT_NEAR(4 * effective_shear_modulus(m, m) / effective_modulus(m, m), 2 * (1 - nu) / (2 - nu), 1e-14);
  }
}

TEST(DampingConstant, OfAnElasticImpactIsZero) { EXPECT_EQ(damping_constant(1), 0); }

TEST(DampingConstant, SolvesTheImpactOfADampedOscillator) {
  // Underdamped: phi = asin(gamma / sqrt 5) gives back e.
  for (const double e : {0.99, 0.9, 0.7, 0.5, 0.3, 0.136}) {
    const double phi = std::asin(damping_constant(e) / std::sqrt(5.0));
    EXPECT_NEAR(std::exp(-(M_PI - 2 * phi) * std::tan(phi)), e, 1e-12) << e;
  }
  // Overdamped: psi = acosh(gamma / sqrt 5).
  for (const double e : {0.135, 0.1, 0.05, 0.01}) {
    const double psi = std::acosh(damping_constant(e) / std::sqrt(5.0));
    EXPECT_NEAR(std::exp(-2 * psi / std::tanh(psi)), e, 1e-12) << e;
  }
}

TEST(DampingConstant, IsContinuousAndFallsWithTheRestitution) {
  // Both branches end at critical damping, gamma = sqrt 5 at e = exp(-2).
  EXPECT_NEAR(damping_constant(std::exp(-2.0) * (1 + 1e-6)), std::sqrt(5.0), 1e-5);
  EXPECT_NEAR(damping_constant(std::exp(-2.0) * (1 - 1e-6)), std::sqrt(5.0), 1e-5);
  double before = damping_constant(1e-3);
  for (double e = 0.002; e <= 1; e += 0.001) {
    const double now = damping_constant(e);
    EXPECT_LT(now, before) << e;
    before = now;
  }
}

TEST(DampingConstant, RefusesWhatIsNoRestitution) {
  for (const double e : {0.0, -0.1, 1.0001, std::nan("")})
    EXPECT_THAT(refusal([&] { damping_constant(e); }), HasSubstr("contact.restitution")) << e;
}

}  // namespace
}  // namespace clogflow
