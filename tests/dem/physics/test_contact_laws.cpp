// One contact: springs, sliders and their sum, against hand values, limits and symmetries.
#include <cmath>

#include <gtest/gtest.h>

#include "dem/physics/contact_laws.hpp"

namespace clogflow {
namespace {

using V = Vec3;
using Slider = SliderParameters<double>;

double norm(const V& v) { return std::sqrt(dot(v, v)); }

TEST(Hertz, StiffnessAndForce) {
  // Chung & Ooi test 1 at its deepest: 4/3 * 25e9 * sqrt(5e-3) * (274.1e-6)^1.5 = 10.696 kN
  const double overlap = 274.1e-6, root = std::sqrt(5e-3 * overlap);
  EXPECT_NEAR(hertz_stiffness(25e9, root) * overlap, 10.696e3, 2);
  EXPECT_EQ(hertz_stiffness(25e9, 0.0), 0.0);
}

TEST(Hertz, ForceIsNeverAttractive) {
  EXPECT_EQ(normal_force(1.0, 10.0, 1.0), 0.0);  // flying apart fast
  EXPECT_EQ(normal_force(1.0, 10.0, 0.1), 0.0);
  EXPECT_EQ(normal_force(1.0, 10.0, -1.0), 11.0);  // approaching
}

TEST(Mindlin, Stiffness) {
  // 8 G* sqrt(R* delta), G* = 20e9 / 3.6, at sqrt = 1e-3: 8 * 5.5556e9 * 1e-3 = 4.4444e7 N/m
  EXPECT_NEAR(mindlin_stiffness(1.0, 20e9 / 3.6, 1e-3), 4.44444444e7, 1);
  EXPECT_DOUBLE_EQ(mindlin_stiffness(2.0 / 3, 3.0, 2.0), 32.0);
}

TEST(TurnIntoPlane, KeepsTheLengthAndLeavesThePlane) {
  const V normal{2.0 / 3, -1.0 / 3, 2.0 / 3};
  for (const double scale : {1e-300, 1e-150, 1e-12, 1.0, 1e100}) {
    if (scale < 1e-140) continue;  // the square of 1e-150 is below the smallest double
    const V spring = scale * V{0.3, -2, 0.5};
    const V turned = turn_into_plane(spring, normal);
    EXPECT_NEAR(norm(turned) / norm(spring), 1, 1e-15) << scale;
    EXPECT_NEAR(dot(turned, normal) / norm(spring), 0, 1e-15) << scale;
  }
}

TEST(TurnIntoPlane, OfASpringInThePlaneChangesNothing) {
  const V turned = turn_into_plane(V{3, 4, 0}, V{0, 0, 1});
  EXPECT_EQ(turned.x, 3);
  EXPECT_EQ(turned.y, 4);
  EXPECT_EQ(turned.z, 0);
}

TEST(TurnIntoPlane, OfNothingAndOfANormalSpringIsZero) {
  EXPECT_EQ(norm(turn_into_plane(V{0, 0, 0}, V{0, 0, 1})), 0);
  EXPECT_EQ(norm(turn_into_plane(V{0, 0, 5}, V{0, 0, 1})), 0);
}

TEST(SpringSlider, SticksBelowTheLimitAsASpring) {
  const auto [spring, force] =
      spring_slider(V{1, 0, 0}, V{0, 2, 0}, Slider{.stiffness = 10, .dashpot = 0, .limit = 100, .dt = 0.5});
  EXPECT_EQ(spring.x, 1);
  EXPECT_EQ(spring.y, 1);
  EXPECT_EQ(force.x, -10);
  EXPECT_EQ(force.y, -10);
}

TEST(SpringSlider, SlipsAtTheLimitAgainstTheMotion) {
  const auto [spring, force] =
      spring_slider(V{3, 4, 0}, V{0, 0, 0}, Slider{.stiffness = 10, .dashpot = 0, .limit = 5, .dt = 1});
  // Cut back from length 5 to 0.5, direction kept.
  EXPECT_NEAR(spring.x, 0.3, 1e-15);
  EXPECT_NEAR(spring.y, 0.4, 1e-15);
  EXPECT_NEAR(force.x, -3, 1e-14);
  EXPECT_NEAR(force.y, -4, 1e-14);
}

TEST(SpringSlider, DashpotNeverLiftsFrictionAboveTheLimit) {
  for (const double speed : {-1e3, -1.0, 0.0, 1.0, 1e3}) {
    const auto [spring, force] =
        spring_slider(V{0.1, 0, 0}, V{speed, speed, 0}, Slider{.stiffness = 10, .dashpot = 7, .limit = 5, .dt = 1e-3});
    EXPECT_LE(norm(force), 5 * (1 + 1e-15));
    const auto along = spring_slider(0.1, speed, Slider{.stiffness = 10, .dashpot = 7, .limit = 5, .dt = 1e-3});
    EXPECT_LE(std::abs(along.force), 5);
  }
}

TEST(SpringSlider, WithoutFrictionRemembersNothing) {
  const auto [spring, force] =
      spring_slider(V{1, 2, 3}, V{4, 5, 6}, Slider{.stiffness = 10, .dashpot = 7, .limit = 0, .dt = 1});
  EXPECT_EQ(norm(spring), 0);
  EXPECT_EQ(norm(force), 0);
  const auto along = spring_slider(1.0, 4.0, Slider{.stiffness = 10, .dashpot = 7, .limit = 0, .dt = 1});
  EXPECT_EQ(along.spring, 0);
  EXPECT_EQ(along.force, 0);
}

TEST(SpringSlider, HasNoLengthOfItsOwn) {
  // The same contact 1e-12 m small and 1 m large: springs and forces in proportion, in both regimes.
  for (const double limit : {0.5, 50.0})
    for (double scale = 1e-12; scale <= 1; scale *= 10) {
      const Slider p{10, 0.1, limit * scale, 0.01};
      const auto small = spring_slider(scale * V{0.3, -0.2, 0.1}, scale * V{5, 1, 2}, p);
      const auto one = spring_slider(V{0.3, -0.2, 0.1}, V{5, 1, 2}, Slider{10, 0.1, limit, 0.01});
      EXPECT_NEAR(small.spring.x / scale, one.spring.x, 1e-14);
      EXPECT_NEAR(small.force.y / scale, one.force.y, 1e-13);
    }
}

TEST(RollingAndTorsion, MeasureTheRightSpins) {
  const V n{0, 0, 1};
  // v_r = -R n x w: spin about y moves the contact along x; a spin about n rolls nothing.
  const V rolling = rolling_velocity(0.5, n, V{0, 3, 0});
  EXPECT_EQ(rolling.x, 1.5);
  EXPECT_EQ(rolling.y, 0);
  EXPECT_EQ(rolling.z, 0);
  EXPECT_EQ(norm(rolling_velocity(0.5, n, V{0, 0, 3})), 0);
  EXPECT_EQ(torsion_velocity(0.5, n, V{7, 8, 3}), 3.0);  // 2 R* n.w
  // A pseudo-force against the velocity gives a torque against the spin.
  EXPECT_LT(dot(rolling_torque(0.5, n, -rolling), V{0, 3, 0}), 0);
  EXPECT_EQ(torsion_torque(0.5, 2.0), 2.0);
}

constexpr Hertz hertz{
    .modulus = 2e6, .shear_modulus = 5e5, .tangential_factor = 2.0 / 3, .gamma = 0.4, .tangential_damping = 0.6};
constexpr FrictionLaw rough{.sliding = 0.6, .rolling = 0.5, .torsion = 0.4};

ContactGeometry<double> geometry(const V& normal) {
  return {normal, 1e-7, 8e-6, 1e-11, 16e-6 - 0.5e-7, 16e-6 - 0.5e-7};
}

constexpr ContactTerms all{true, true, true};

TEST(ContactLoads, ObeyNewtonsThirdLawInTheSpringsToo) {
  const V n{2.0 / 3, -1.0 / 3, 2.0 / 3};
  const ContactMotion<double> motion{{1e-3, -2e-3, 5e-4}, {3, -20, 10}, {-7, 5, 30}};
  const ContactMotion<double> mirrored{-motion.velocity, motion.spin_j, motion.spin_i};
  Springs<double> s{{1e-9, 2e-9, 0}, {0, 1e-9, 5e-10}, 3e-10};
  // Seen from the other side n and w_i - w_j both turn round: n x w and n . w stay.
  Springs<double> t{-s.sliding, s.rolling, s.torsion};
  const auto ij = contact_loads<LudingTurning, all>(hertz, rough, geometry(n), motion, 1e-6, s);
  const auto ji = contact_loads<LudingTurning, all>(hertz, rough, geometry(-n), mirrored, 1e-6, t);
  const double force = norm(ij.force), torque = norm(ij.torque_i);
  EXPECT_LT(norm(ij.force + ji.force), 1e-14 * force);
  EXPECT_LT(norm(ij.torque_i - ji.torque_j), 1e-13 * torque);
  EXPECT_LT(norm(ij.torque_j - ji.torque_i), 1e-13 * torque);
  EXPECT_LT(norm(s.sliding + t.sliding), 1e-14 * norm(s.sliding));
  EXPECT_LT(norm(s.rolling - t.rolling), 1e-14 * norm(s.rolling));
  EXPECT_NEAR(s.torsion, t.torsion, 1e-14 * std::abs(s.torsion));
}

TEST(ContactLoads, GiveNoAngularMomentum) {
  // torques + arm between the centres x force = 0, whatever the motion.
  const V n{0, 0.6, 0.8};
  Springs<double> s{{1e-9, 0, 0}, {1e-9, 0, 0}, 1e-10};
  const auto g = geometry(n);
  const auto loads =
      contact_loads<LudingTurning, all>(hertz, rough, g, {{1e-3, 0, 2e-3}, {1, 2, 3}, {30, 20, 10}}, 1e-6, s);
  const V orbital = cross((g.arm_i + g.arm_j) * n, loads.force);
  EXPECT_LT(norm(loads.torque_i + loads.torque_j + orbital), 1e-13 * norm(loads.torque_i));
}

TEST(ContactLoads, OfARigidRotationAreTheElasticForceAlone) {
  // Two spheres that turn as one body about any axis do not move against each other.
  const V n{0, 0.6, 0.8}, w{3, -2, 5};
  const auto g = geometry(n);
  const ContactMotion<double> motion{cross(w, (g.arm_i + g.arm_j) * n), w, w};
  Springs<double> s{};
  const auto loads = contact_loads<LudingTurning, all>(hertz, rough, g, motion, 1e-6, s);
  const double elastic = hertz_stiffness(hertz.modulus, std::sqrt(g.radius * g.overlap)) * g.overlap;
  EXPECT_NEAR(norm(loads.force), elastic, 1e-12 * elastic);
  EXPECT_LT(norm(loads.torque_i), 1e-15 * elastic * g.radius / 1e-3);
}

TEST(ContactLoads, TurnWithTheFrame) {
  // A quarter turn about x: (x, y, z) -> (x, -z, y); components move, values stay.
  const auto turn = [](const V& v) { return V{v.x, -v.z, v.y}; };
  const V n{2.0 / 3, -1.0 / 3, 2.0 / 3};
  const ContactMotion<double> m{{1e-3, -2e-3, 5e-4}, {3, -20, 10}, {-7, 5, 30}};
  Springs<double> s{{1e-9, 2e-9, 0}, {0, 1e-9, 1e-9}, 1e-9};
  Springs<double> t{turn(s.sliding), turn(s.rolling), s.torsion};
  const auto here = contact_loads<LudingTurning, all>(hertz, rough, geometry(n), m, 1e-6, s);
  const auto there = contact_loads<LudingTurning, all>(hertz, rough, geometry(turn(n)),
                                                       {turn(m.velocity), turn(m.spin_i), turn(m.spin_j)}, 1e-6, t);
  EXPECT_LT(norm(turn(here.force) - there.force), 1e-14 * norm(here.force));
  EXPECT_LT(norm(turn(here.torque_i) - there.torque_i), 1e-14 * norm(here.torque_i));
}

/// A small sphere that rolls without slip in the groove of two large ones along x, half a step after and half a step
/// before it is on top of them.
struct Rolling {
  double large, small, speed = 0.02, dt = 1e-6;

  ContactGeometry<double> geometry() const {
    const double distance = large + small, way = std::sqrt(distance * distance - large * large);
    return {{large / distance, 0, way / distance}, 0, small, 1e-7, small, large, 1 / distance};
  }

  /// Angle about the axis in one step.
  double turn() const { return speed * dt / (geometry().normal.z / geometry().turning); }

  ContactMotion<double> motion() const {
    return {{0, speed, speed * turn() / 2}, {-speed / (small * geometry().normal.z), 0, 0}, {0, 0, 0}};
  }
};

TEST(SlidingVelocity, OfASphereThatRollsIsZeroAboutTheNormalOfItsTime) {
  for (const double ratio : {1.0, 5.0, 20.0}) {
    const Rolling rolling{ratio * 2.5e-4, 2.5e-4};
    const auto g = rolling.geometry();
    const auto m = rolling.motion();
    const double approach = dot(m.velocity, g.normal);
    const double aside = norm(sliding_velocity<false>(g, m, approach, rolling.dt));
    EXPECT_NEAR(aside, rolling.speed * rolling.turn() / 2 * g.normal.x, 1e-3 * aside) << ratio;
    EXPECT_LT(norm(sliding_velocity<true>(g, m, approach, rolling.dt)), 1e-3 * aside) << ratio;
  }
}

TEST(SlidingVelocity, OfANormalThatDoesNotTurnHasNoMore) {
  const ContactMotion<double> m{{1e-3, -2e-3, 5e-4}, {3, -20, 10}, {-7, 5, 30}};
  const auto g = geometry({2.0 / 3, -1.0 / 3, 2.0 / 3});
  const double approach = dot(m.velocity, g.normal);
  const V without = sliding_velocity<false>(g, m, approach, 1e-6), with = sliding_velocity<true>(g, m, approach, 1e-6);
  EXPECT_EQ(norm(with - without), 0);
}

TEST(ContactLoads, DoublingIsTheExperimentItSaysItIs) {
  Springs<double> s{};
  s.torsion = 1e-12;
  const ContactMotion<double> still{};
  contact_loads<DoublingTurning, all>(hertz, rough, geometry({0, 0, 1}), still, 1e-6, s);
  EXPECT_EQ(s.torsion, 2e-12);
  contact_loads<LudingTurning, all>(hertz, rough, geometry({0, 0, 1}), still, 1e-6, s);
  EXPECT_EQ(s.torsion, 2e-12);
}

TEST(StoredEnergy, OfHertzAndSprings) {
  // 2/5 k delta^2 = 8/15 E* sqrt(R*) delta^(5/2), the integral of the force.
  auto g = geometry({0, 0, 1});
  const double expected = 8.0 / 15 * 2e6 * std::sqrt(8e-6) * std::pow(1e-7, 2.5);
  EXPECT_NEAR(stored_energy<LudingTurning>(hertz, g, {}) / expected, 1, 1e-14);
  const Springs<double> s{{3e-9, 0, 0}, {0, 4e-9, 0}, 12e-9};
  const double kt = mindlin_stiffness(2.0 / 3, 5e5, std::sqrt(8e-6 * 1e-7));
  EXPECT_NEAR((stored_energy<LudingTurning>(hertz, g, s) - expected) / (0.5 * kt * 169e-18), 1, 1e-9);
}

}  // namespace
}  // namespace clogflow
