// A sphere on a floor and two spheres in contact: sliding, rolling and spinning by their closed forms.
#include <gtest/gtest.h>

#include "dem/physics/material_pair.hpp"
#include "tests/dem/laboratory.hpp"

namespace clogflow::test {
namespace {

/// Overlap at which the floor carries the load F: (3 F / (4 E* sqrt r))^(2/3).
double resting_overlap(const Model& model, double load, double radius) {
  const Scene& s = model.scene;
  return std::pow(3 * load /
                      (4 *
                       effective_modulus({s.contact.youngs_modulus, s.contact.poisson_ratio},
                                         {s.contact.wall_youngs_modulus, s.contact.wall_poisson_ratio}) *
                       std::sqrt(radius)),
                  2.0 / 3);
}

/// A size to test a law at: it must hold for micrometres as for metres.
struct Size {
  const char* name;
  Substance substance;
  double load;   ///< on the floor [N]
  double speed;  ///< [m/s]
  double step;   ///< [s]
};

const Size metre{"metre", {1e9, 0.3, 1000, 1}, 1000, 0.1, 1e-5};
const Size micrometre{"micrometre", {3e6, 0.35, 1062, 33e-6}, 1e-9, 1e-3, 1e-8};

class Floor : public testing::TestWithParam<Size> {
protected:
  Scene scene(const Friction& friction) const {
    const Size& size = GetParam();
    Scene s = laboratory_scene(size.substance, size.step);
    set_floor(s, 200 * size.substance.diameter);
    set_friction(s, friction);
    s.contact.restitution = 0.5;
    s.body_force = {0, 0, -size.load};
    return s;
  }

  double radius() const { return GetParam().substance.diameter / 2; }

  /// On the floor at its resting height, moving along x.
  Particle resting(const Scene& s) const {
    const Model model = make_model(s, nullptr, {});
    return {
        .radius = radius(), .z = radius() - resting_overlap(model, GetParam().load, radius()), .vx = GetParam().speed};
  }

  double mass() const { return GetParam().substance.density * 4.0 / 3 * M_PI * std::pow(radius(), 3); }
};

TEST_P(Floor, SlidingSphereEndsRollingAtFiveSevenths) {
  const double mu = 0.3, u0 = GetParam().speed;
  const Scene s = scene({.sliding = mu});
  Laboratory lab(s, {resting(s)});
  // Slip ends at t = 2/7 u0 m / (mu F).
  const double slip = 2.0 / 7 * u0 * mass() / (mu * GetParam().load);
  lab.run_until(slip / 2);
  EXPECT_NEAR(lab.velocity(0).x, u0 * (1 - 1.0 / 7), 2e-3 * u0) << "Coulomb's law while it slips";
  lab.run_until(4 * slip);
  // The lever is r - delta / 2, as the contact area lies inside the sphere: to the overlap.
  EXPECT_NEAR(lab.velocity(0).x, 5.0 / 7 * u0, 2e-3 * u0);
  EXPECT_NEAR(lab.spin(0).y * radius(), 5.0 / 7 * u0, 2e-3 * u0);
}

TEST_P(Floor, WithoutFrictionSlidesForEver) {
  const Scene s = scene({});
  Laboratory lab(s, {resting(s)});
  lab.run_until(2000 * GetParam().step);
  EXPECT_EQ(lab.velocity(0).x, GetParam().speed);
  EXPECT_EQ(lab.spin(0).norm(), 0);
}

TEST_P(Floor, RollingFrictionSlowsASphereThatOnlySpins) {
  // A sphere that neither slides nor moves: torque of rolling friction alone, r mu_r F.
  const double mu = 0.2;
  const Scene s = scene({.rolling = mu});
  Particle sphere = resting(s);
  sphere.vx = 0, sphere.wy = GetParam().speed / radius();
  Laboratory lab(s, {sphere});
  const double inertia = 0.4 * mass() * radius() * radius();
  const double stop = sphere.wy * inertia / (mu * radius() * GetParam().load);
  lab.run_until(stop / 2);
  EXPECT_NEAR(lab.spin(0).y, sphere.wy / 2, 5e-3 * sphere.wy);
  lab.run_until(3 * stop);
  EXPECT_LT(std::abs(lab.spin(0).y), 5e-3 * sphere.wy);
}

TEST_P(Floor, TorsionFrictionSlowsASphereThatTwists) {
  // Torque 2 r mu_o F about the normal.
  const double mu = 0.2;
  const Scene s = scene({.torsion = mu});
  Particle sphere = resting(s);
  sphere.vx = 0, sphere.wz = GetParam().speed / radius();
  Laboratory lab(s, {sphere});
  const double inertia = 0.4 * mass() * radius() * radius();
  const double stop = sphere.wz * inertia / (2 * mu * radius() * GetParam().load);
  lab.run_until(stop / 2);
  EXPECT_NEAR(lab.spin(0).z, sphere.wz / 2, 5e-3 * sphere.wz);
}

INSTANTIATE_TEST_SUITE_P(AtAnySize, Floor, testing::Values(metre, micrometre),
                         [](const auto& info) { return std::string(info.param.name); });

/// Two spheres pressed together, one spinning about the line of centres.
double spin_after(TorsionUpdate update, int steps) {
  Scene s = laboratory_scene({3e6, 0.35, 1062, 33e-6}, 1e-8);
  set_friction(s, {.sliding = 0.6, .rolling = 0.6, .torsion = 0.6});
  s.contact.restitution = 0.7;
  s.contact.torsion_update = update;
  // Held by two walls that touch the spheres: a pack of two.
  const double r = 16.5e-6, overlap = 1e-3 * r;
  s.box.present = true;
  s.box.min = {-2 * r + 1.5 * overlap, -3 * r, -3 * r};
  s.box.max = {2 * r - 1.5 * overlap, 3 * r, 3 * r};
  s.contact.wall_friction = {};
  Laboratory lab(s, {{.radius = r, .x = -r + overlap / 2, .wx = 10}, {.radius = r, .x = r - overlap / 2}});
  double largest = 0;
  for (int k = 0; k < steps; ++k) {
    lab.step();
    if (k > steps / 2) largest = std::max(largest, std::abs((lab.spin(0) - lab.spin(1)).x));
  }
  return largest;
}

TEST(SpinAboutTheNormal, DecaysWithTheObjectiveSpring) {
  EXPECT_LT(spin_after(TorsionUpdate::objective, 200000), 1e-6 * 10);
}

TEST(SpinAboutTheNormal, DoesNotDecayWithTheDoublingSpring) {
  EXPECT_GT(spin_after(TorsionUpdate::doubling, 200000), 1e-2 * 10);
}

TEST(Sphere, OnAnInclineRollsWithFiveSeventhsOfGravity) {
  // Gravity turned instead of the floor: down the slope g sin, onto it g cos; mu > 2/7 tan.
  const double r = 0.5, load = 1000, angle = 0.3;
  Scene s = laboratory_scene({1e7, 0.3, 1000, 2 * r}, 1e-4);
  set_floor(s, 200);
  set_friction(s, {.sliding = 0.5});
  s.contact.restitution = 0.5;
  s.body_force = {load * std::sin(angle), 0, -load * std::cos(angle)};
  const double overlap = resting_overlap(make_model(s, nullptr, {}), load * std::cos(angle), r);
  Laboratory lab(s, {{.radius = r, .z = r - overlap}});
  lab.run_until(2);
  const double mass = 1000 * 4.0 / 3 * M_PI * r * r * r;
  EXPECT_NEAR(lab.velocity(0).x, 5.0 / 7 * load * std::sin(angle) / mass * 2, 2e-3);
}

}  // namespace
}  // namespace clogflow::test
