// Contact laws beside Hertz': linear springs, spheres that stick, MercuryDPM's rolling. Closed forms and
// published numbers.
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "coupling/scene/scene_keys.hpp"
#include "dem/physics/contact_laws.hpp"
#include "tests/coupling/refusal.hpp"
#include "tests/dem/laboratory.hpp"

namespace clogflow::test {
namespace {

using testing::HasSubstr;
constexpr double pi = std::numbers::pi;
constexpr double diameter = 20e-6, density = 1000, radius = diameter / 2;

double mass() { return density * pi / 6 * std::pow(diameter, 3); }

/// Two equal spheres of soft matter, elastic and without friction.
Scene soft_scene(double step) { return laboratory_scene({1e7, 0.3, density, diameter}, step); }

struct Rebound {
  double restitution = 0, overlap = 0, duration = 0;
  bool parted = false;
};

/// Two spheres that meet at a closing speed, followed for a given time at most.
Rebound meet(const Scene& scene, double speed, double time) {
  const double gap = 1e-3 * speed * scene.time.step;
  Laboratory lab(scene, {{.radius = radius, .x = -radius - gap, .vx = speed / 2},
                         {.radius = radius, .x = radius + gap, .vx = -speed / 2}});
  Rebound seen;
  for (bool met = false; lab->time() < time && !seen.parted;) {
    lab->compute_forces();
    const bool touching = lab->pair_tally().contacts > 0;
    seen.overlap = std::max(seen.overlap, lab->pair_tally().largest_overlap);
    seen.parted = met && !touching;
    if (touching) met = true, seen.duration += lab->model().dt;
    lab->advance();
  }
  seen.restitution = (lab.velocity(1) - lab.velocity(0)).x / speed;
  return seen;
}

Scene hooke_scene(double restitution) {
  Scene scene = soft_scene(1e-9);
  scene.contact.law = "hooke";
  scene.contact.stiffness = 2;
  scene.contact.restitution = restitution;
  return scene;
}

TEST(Hooke, ElasticImpactIsHalfASwing) {
  // pi sqrt(m* / k) and v sqrt(m* / k), m* = m / 2.
  const double swing = std::sqrt(mass() / 2 / 2.0);
  const Rebound seen = meet(hooke_scene(1), 0.1, 1e-3);
  EXPECT_NEAR(seen.duration / (pi * swing), 1, 1e-3);
  EXPECT_NEAR(seen.overlap / (0.1 * swing), 1, 1e-3);
  EXPECT_NEAR(seen.restitution, 1, 1e-4);
}

TEST(Hooke, OutIsRestitutionInAtAnySpeed) {
  for (const double e : {0.9, 0.5, 0.1})
    for (const double speed : {1e-3, 1.0}) EXPECT_NEAR(meet(hooke_scene(e), speed, 1e-3).restitution, e, 2e-3) << e;
}

TEST(Hooke, IsToldWhatItNeedsAndWhatItDoesNot) {
  const std::string text = R"(
[particles]
diameter = "20 um"
density = "1000 kg/m3"
[contact]
youngs_modulus = "1 MPa"
poisson_ratio = 0.3
[time]
end = "1 s"
step = "1 us"
)";
  const auto refused = [&](const Overrides& overrides) {
    return refusal([&] { parse_scene(text, "scene", overrides); });
  };
  EXPECT_THAT(refused({"contact.law=hooke"}), HasSubstr("contact.stiffness is missing"));
  EXPECT_THAT(refused({"contact.stiffness=2 N/m"}), HasSubstr("is only for contact.law = \"hooke\""));
  EXPECT_THAT(refused({"contact.law=jkr"}), HasSubstr("contact.surface_energy is missing"));
  EXPECT_THAT(refused({"contact.law=hooke", "contact.stiffness=2 N/m", "contact.turning=mercury"}),
              HasSubstr("has neither contact.turning"));
  const Scene scene = parse_scene(text, "scene", {"contact.law=hooke", "contact.stiffness=2 N/m"});
  EXPECT_EQ(scene.contact.tangential_factor, 2.0 / 7);
}

constexpr double w = 1e-3;  // [J/m2]

constexpr ContactMaterials materials{
    .own = {1e7, 0.3}, .other = {1e7, 0.3}, .tangential_factor = 1, .surface_energy = w};

Jkr sticky() { return Jkr::of(materials); }

ContactGeometry<double> pressed(double overlap) { return wall_contact(Vec3{0, 0, 1}, overlap, radius / 2, mass() / 2); }

TEST(Jkr, HasTheForcesOfItsAuthors) {
  const Jkr law = sticky();
  const double pull_off = 1.5 * pi * w * radius / 2;
  // At no overlap -8/9, at the end of the stable branch -5/9 of the pull-off force.
  EXPECT_NEAR(law.respond(pressed(0), 0.0).force / pull_off, -8.0 / 9, 1e-12);
  EXPECT_NEAR(law.respond(pressed(-law.reach(radius / 2)), 0.0).force / pull_off, -5.0 / 9, 1e-6);
  // In between lies the pull-off force itself, and nothing below it.
  double least = 0;
  for (int k = 0; k <= 1000; ++k)
    least = std::min(least, law.respond(pressed(-law.reach(radius / 2) * k / 1000), 0.0).force);
  EXPECT_NEAR(least / pull_off, -1, 1e-5);
}

TEST(Jkr, WithoutSurfaceEnergyIsHertz) {
  Jkr law = sticky();
  law.surface_energy = 1e-12;
  const Hertz hertz = Hertz::of({.own = {1e7, 0.3}, .other = {1e7, 0.3}, .tangential_factor = 1});
  for (const double overlap : {1e-9, 1e-7, 2e-6})
    EXPECT_NEAR(law.respond(pressed(overlap), 0.0).force / hertz.respond(pressed(overlap), 0.0).force, 1, 1e-3);
}

TEST(Jkr, ItsRadiusSolvesTheQuartic) {
  const Jkr law = sticky();
  const double reach = law.reach(radius / 2);
  for (const double overlap : {-0.999 * reach, -0.5 * reach, 0.0, reach, 100 * reach}) {
    const double a = law.contact_radius(pressed(overlap));
    const double back = a * a / (radius / 2) - std::sqrt(2 * pi * w * a / law.modulus);
    EXPECT_NEAR(back, overlap, 1e-10 * std::max(reach, overlap)) << overlap / reach;
    EXPECT_NEAR(law.overlap_at(law.respond(pressed(0), 0.0).force, radius / 2), 0, 1e-9 * reach);
  }
}

TEST(Jkr, StoredEnergyIsTheIntegralOfTheForce) {
  const Jkr law = sticky();
  const double h = 1e-12;
  for (const double overlap : {-1e-9, 0.0, 1e-8, 1e-6}) {
    const double slope = (law.stored_energy(pressed(overlap + h)) - law.stored_energy(pressed(overlap - h))) / (2 * h);
    const double force = law.respond(pressed(overlap), 0.0).force;
    EXPECT_NEAR(slope, force, 1e-5 * std::abs(force)) << overlap;
  }
  // Work to part spheres that touch: 7.09 (w^5 R*^4 / E*^2)^(1/3), Thornton & Ning, Powder Technol. 99 (1998) 154.
  const double parting = law.stored_energy(pressed(-law.reach(radius / 2))) - law.stored_energy(pressed(0));
  EXPECT_NEAR(parting / std::cbrt(std::pow(w, 5) * std::pow(radius / 2, 4) / std::pow(law.modulus, 2)), 7.09, 0.005);
}

Scene sticky_scene(double step, const char* law = "jkr") {
  Scene scene = soft_scene(step);
  scene.contact.law = law;
  scene.contact.surface_energy = w;
  return scene;
}

TEST(Jkr, SpheresStickBelowTheCriticalSpeed) {
  // 1/2 m* v^2 = 7.09 (w^5 R*^4 / E*^2)^(1/3) for elastic spheres (Thornton & Ning 1998).
  const double parting = 7.09 * std::cbrt(std::pow(w, 5) * std::pow(radius / 2, 4) / std::pow(sticky().modulus, 2));
  const double critical = std::sqrt(2 * parting / (mass() / 2));
  EXPECT_FALSE(meet(sticky_scene(1e-9), 0.97 * critical, 2e-5).parted);
  const Rebound fast = meet(sticky_scene(1e-9), 2 * critical, 2e-5);
  EXPECT_TRUE(fast.parted);
  EXPECT_TRUE(meet(sticky_scene(1e-9), 1.03 * critical, 2e-5).parted);
  // What is lost is the work of parting: e^2 = 1 - (v_c / v)^2.
  EXPECT_NEAR(fast.restitution, std::sqrt(1 - 0.25), 5e-3);
}

/// Whether a sphere that touches the floor leaves it under a pull. Braked, so that it does not swing past where
/// it would be held.
template <class Law>
bool leaves(double pull) {
  Scene scene = sticky_scene(1e-9, Law::word.data());
  scene.contact.restitution = 0.3;
  set_floor(scene, 1e-3);
  scene.body_force = {0, 0, pull};
  Laboratory lab(scene, {{.radius = radius, .z = (1 - 1e-6) * radius}});
  lab.run_until(1e-4);
  lab->compute_forces();
  return lab->wall_tally().contacts == 0;
}

TEST(Jkr, TheFloorHoldsASphereUpToThePullOffForce) {
  const double pull_off = 1.5 * pi * w * radius;
  EXPECT_FALSE(leaves<Jkr>(0.96 * pull_off));
  EXPECT_TRUE(leaves<Jkr>(1.04 * pull_off));
}

TEST(Dmt, TheFloorHoldsASphereUpToThePullOffForce) {
  const double pull_off = 2 * pi * w * radius;
  EXPECT_FALSE(leaves<Dmt>(0.96 * pull_off));
  EXPECT_TRUE(leaves<Dmt>(1.04 * pull_off));
}

TEST(Dmt, IsHertzUnderAConstantLoad) {
  const Dmt law = Dmt::of(materials);
  const Hertz hertz = Hertz::of(materials);
  const double pull_off = 2 * pi * w * radius / 2;
  for (const double overlap : {0.0, 1e-9, 1e-6})
    EXPECT_NEAR(law.respond(pressed(overlap), 0.0).force, hertz.respond(pressed(overlap), 0.0).force - pull_off,
                1e-12 * pull_off);
  // At rest under no load the overlap is that of Hertz under the pull-off force.
  EXPECT_NEAR(law.respond(pressed(law.overlap_at(0, radius / 2)), 0.0).force / pull_off, 0, 1e-12);
  EXPECT_EQ(law.overlap_at(0, radius / 2), hertz.overlap_at(pull_off, radius / 2));
}

TEST(Dmt, StoredEnergyIsTheIntegralOfTheForce) {
  const Dmt law = Dmt::of(materials);
  const double h = 1e-12;
  for (const double overlap : {1e-9, 1e-8, 1e-6}) {
    const double slope = (law.stored_energy(pressed(overlap + h)) - law.stored_energy(pressed(overlap - h))) / (2 * h);
    const double force = law.respond(pressed(overlap), 0.0).force;
    EXPECT_NEAR(slope, force, 1e-5 * std::abs(force)) << overlap;
  }
}

TEST(Dmt, AnElasticImpactGivesBackWhatItTakesAndADampedOneSticks) {
  Scene scene = sticky_scene(1e-9, "dmt");
  scene.contact.restitution = 1;
  const Rebound elastic = meet(scene, 0.05, 1e-4);
  EXPECT_TRUE(elastic.parted);
  EXPECT_NEAR(elastic.restitution, 1, 5e-3);
  scene.contact.restitution = 0.3;
  EXPECT_FALSE(meet(scene, 1e-3, 1e-4).parted);
}

TEST(Jkr, SpheresThatDoNotTouchFeelNothing) {
  Laboratory lab(sticky_scene(1e-9), {{.radius = radius}, {.radius = radius, .x = 2 * radius + 1e-10}});
  lab->compute_forces();
  EXPECT_EQ(lab.force(0).norm(), 0);
}

TEST(MercuryTurning, HasTwiceTheTorqueAndSixTimesTheStiffness) {
  const Hertz law{.modulus = 2e6, .shear_modulus = 5e5, .tangential_factor = 2.0 / 3};
  const auto torque = [&]<class Turning>(const FrictionLaw& friction, double spin) {
    Springs<double> springs{};
    const ContactMotion<double> motion{{0, 0, 0}, {spin, 0, 0}, {0, 0, 0}};
    return contact_loads<Turning, ContactTerms{false, true, false}>(law, friction, pressed(1e-7), motion, 1e-6, springs)
        .torque_i.x;
  };
  const FrictionLaw rough{.rolling = 1e9}, slippery{.rolling = 0.1};
  EXPECT_NEAR(torque.operator()<MercuryTurning>(rough, 1e-3) / torque.operator()<LudingTurning>(rough, 1e-3), 6, 1e-12);
  EXPECT_NEAR(torque.operator()<MercuryTurning>(slippery, 1e9) / torque.operator()<LudingTurning>(slippery, 1e9), 2,
              1e-12);
}

TEST(Registry, SaysWhichWaysOfTurningALawHas) {
  EXPECT_THAT(refusal([] { make_contact_law("hooke", "mercury", {}, {}); }), HasSubstr("(there is \"luding\")"));
}

TEST(Registry, EveryWordOfASceneHasARow) {
  for (const std::string_view law : std::get<WordSlot>(find_key("contact.law")->slot).words)
    EXPECT_NO_THROW(make_contact_law(
        law, "luding", {.own = {1e7, 0.3}, .other = {1e7, 0.3}, .stiffness = 1, .surface_energy = 1}, {}));
  for (const std::string_view turning : std::get<WordSlot>(find_key("contact.turning")->slot).words)
    EXPECT_NO_THROW(make_contact_law("hertz", turning, {.own = {1e7, 0.3}, .other = {1e7, 0.3}}, {}));
}

}  // namespace
}  // namespace clogflow::test
