// Dimensionless numbers by hand for the paper's scene, and what the plan makes of them.
#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

#include "coupling/flow/flow_reach.hpp"
#include "coupling/flow/flow_rescale.hpp"
#include "dem/physics/dimensionless.hpp"
#include "dem/physics/hertz.hpp"
#include "dem/physics/jkr.hpp"
#include "dem/plan/machine_speed.hpp"
#include "dem/plan/plan.hpp"
#include "dem/plan/term_costs.hpp"
#include "tests/dem/channel_scene.hpp"

namespace clogflow::test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr SphereInFluid paper{.diameter = 33e-6, .density = 1062, .fluid_density = 1062, .viscosity = 1.8e-3};

const PlannedTerm& term_named(const Plan& plan, const std::string& name) {
  return *std::ranges::find(plan.terms, name, &PlannedTerm::term);
}

TEST(Plan, WarnsOfWholeLayersAndKnowsWhatDecides) {
  const std::string layers = "holds 2 whole layers with room for 0 more";
  EXPECT_THAT(warnings(make_plan(cheap_paper_scene({"particles.diameter=50 um"}))), Contains(HasSubstr(layers)));
  EXPECT_THAT(warnings(make_plan(cheap_paper_scene({"particles.diameter=47 um"}))), IsEmpty());
  // 10 D^3 of solids through 4 D x D at 0.33 / 0.67 of 5 mm/s: 0.1015 s. Runs take 0.102 to 0.104 s.
  const Scene scene = cheap_paper_scene({"inlet.start=flowing"});
  const Plan plan = make_plan(scene);
  EXPECT_NEAR(plan.filling_steps * plan.dt, 0.1015, 1e-4);
  const Plan smooth = make_plan(cheap_paper_scene({"contact.friction.rolling=0", "contact.friction.torsion=0"}));
  for (const char* name : {"rolling friction", "torsion friction"}) {
    const auto term = std::ranges::find(smooth.terms, name, &PlannedTerm::term);
    ASSERT_NE(term, smooth.terms.end());
    EXPECT_TRUE(term->needed && !term->modelled);
  }
  EXPECT_THAT(warnings(smooth), IsEmpty());
}

TEST(Plan, TellsWhenParticlesAreTooHeavy) {
  // 0.0724 ms / f(0.55) = 15.5, x 5 mm/s / 47 um = 0.0005 for each unit of mass: seen from 11 on, too much from 202 on.
  const auto reason = [](int mass) {
    return term_named(
               make_plan(cheap_paper_scene({"particles.diameter=47 um", fmt::format("time.mass_scale={}", mass)})),
               "particle inertia")
        .reason;
  };
  EXPECT_THAT(reason(1), HasSubstr("irrelevant"));
  EXPECT_THAT(reason(30), HasSubstr("some per cent of <s> and packing"));
  EXPECT_EQ(reason(300), "mass scaled too far");
}

TEST(Dimensionless, ReynoldsOfThePaper) {
  // 1062 x 5e-3 x 1e-4 / 1.8e-3
  EXPECT_NEAR(reynolds_number(1062, 5e-3, 1e-4, 1.8e-3), 0.295, 1e-12);
}

TEST(Dimensionless, ResponseTime) {
  // rho d^2 / (18 eta) = 1062 x 1.089e-9 / 0.0324; and that over f(0.5) = 20.515.
  EXPECT_NEAR(response_time(paper, 1.0), 3.56950e-5, 1e-9);
  EXPECT_NEAR(response_time(paper, 20.515), 1.73995e-6, 1e-10);
}

TEST(Dimensionless, SettlingOfAHeavierSphere) {
  SphereInFluid heavy = paper;
  heavy.density += 100;
  // 100 x 9.80665 x 1.089e-9 / (18 x 1.8e-3 x 5e-3)
  EXPECT_NEAR(settling_ratio(heavy, 5e-3), 6.5922e-3, 1e-6);
  EXPECT_EQ(settling_ratio(paper, 5e-3), 0);
}

TEST(Dimensionless, Peclet) {
  // 5e-3 x 33e-6 x 5.5983e-7 / 4.0453e-21
  EXPECT_NEAR(peclet_number(paper, 5e-3), 2.2834e7, 1e4);
}

TEST(Dimensionless, CollisionStokes) {
  // 9.9916e-12 x 5e-4 / 2.30931e-12
  EXPECT_NEAR(collision_stokes_number(paper, 5e-4), 2.1633e-3, 1e-6);
}

TEST(Dimensionless, HertzOverlapInvertsTheForce) {
  const double modulus = 1.709e6, radius = 8.25e-6, overlap = 3e-7;
  const double force = hertz_stiffness(modulus, std::sqrt(radius * overlap)) * overlap;
  EXPECT_NEAR(hertz_overlap(force, modulus, radius), overlap, 1e-15);
}

TEST(Plan, OfThePaperNeedsNothingMore) {
  const Plan plan = make_plan(cheap_paper_scene());
  EXPECT_THAT(warnings(plan), IsEmpty());
  EXPECT_LT(plan.dt, plan.limits.smallest());
  // 0.45 x (4e-11 + 0.866e-4 x 2.5e-4 x 1e-4) m3 / 1.8817e-14 m3
  EXPECT_NEAR(plan.particles, 1008, 2);
  EXPECT_GT(plan.filling_steps, 0);
}

TEST(Plan, WarnsOfWhatIsMissing) {
  EXPECT_THAT(warnings(make_plan(cheap_paper_scene({"lubrication.enabled=false"}))),
              Contains(HasSubstr("lubrication is needed")));
  EXPECT_THAT(warnings(make_plan(cheap_paper_scene({"contact.youngs_modulus=1e5 Pa"}))),
              Contains(HasSubstr("raise contact.youngs_modulus")));
  EXPECT_THAT(warnings(make_plan(cheap_paper_scene({"time.mass_scale=1e4"}))),
              Contains(HasSubstr("lower time.mass_scale")));
  EXPECT_THAT(warnings(make_plan(cheap_paper_scene({"particles.density=1300 kg/m3"}))),
              Contains(HasSubstr("gravity is needed")));
  EXPECT_THAT(warnings(make_plan(cheap_paper_scene({"time.step_fraction=0.5"}))), Contains(HasSubstr("is unstable")));
}

TEST(Dimensionless, Womersley) {
  // 50 um sqrt(2 pi / 6.6 ms x 1062 / 1.8e-3) = 5e-5 sqrt(5.6168e8); 3.6e-3 / (pi 1062 1e-8)
  EXPECT_NEAR(womersley_number({1062, 1.8e-3}, 1 / 6.6e-3, 1e-4), 1.18498, 1e-4);
  EXPECT_NEAR(quasi_steady_until({1062, 1.8e-3}, 1e-4), 107.90, 0.01);
}

TEST(Plan, SaysWhatAnOscillationCanChange) {
  const auto plan = [](Overrides more) {
    more.insert(more.begin(), {"flow.oscillation.amplitude=0.5", "unclog.protocol=none"});
    return make_plan(cheap_paper_scene(more));
  };
  const Plan slow = plan({"flow.oscillation.frequency=10 Hz"});
  EXPECT_NEAR(term_named(slow, "inertia of an unsteady flow").value, 0.3044, 1e-3);
  EXPECT_THAT(slow.drive_notes, Contains(HasSubstr("a drive that never goes back cannot change which particles pass")));
  EXPECT_THAT(warnings(slow), IsEmpty());
  EXPECT_THAT(warnings(plan({"flow.oscillation.frequency=200 Hz"})),
              Contains(HasSubstr("inertia of an unsteady flow is needed")));
  const Overrides often = {"flow.oscillation.frequency=10 Hz"};
  EXPECT_THAT(warnings(plan({often[0], "time.mass_scale=250"})),
              Contains(HasSubstr("scaled mass would pretend that the drive matters: lower time.mass_scale")));
  EXPECT_THAT(warnings(plan({often[0], "contact.youngs_modulus=0.4 MPa", "time.step_fraction=0.01"})),
              Contains(HasSubstr("softness would pretend that the drive matters: raise contact.youngs_modulus")));
  const Plan back = plan({often[0], "flow.oscillation.amplitude=1.5", "geometry.expansion_width=400 um"});
  EXPECT_THAT(back.drive_notes, Contains(HasSubstr("the flow goes back")));
  EXPECT_THAT(make_plan(cheap_paper_scene()).drive_notes, IsEmpty());
}

TEST(Plan, EstimatesThePressures) {
  const Plan plan = make_plan(cheap_paper_scene(
      {"flow.drive=pressure", "flow.pressure_drop=1 kPa", "drag.velocity=mixture", "time.integrator=implicit_drag"}));
  // 1008 spheres of f(0.55) 3 pi eta d = 15.5 x 5.6e-7 over 0.55, 1.3 v / 4e-8 m2; f is 15.483.
  const auto& balance = term_named(plan, "balance of pressures");
  EXPECT_TRUE(balance.needed && balance.modelled);
  const double pack = 1008 * 15.483 * 5.598e-7 / 0.55 * 1.3 * 5e-3 / 4e-8;
  EXPECT_NEAR(balance.value * *estimated_pressure_drop(cheap_paper_scene()), pack, 0.01 * pack);
  EXPECT_THAT(plan.drive_notes, Contains(HasSubstr("times the mean flow through the pack at rest")));
  EXPECT_THAT(warnings(plan), Contains(HasSubstr("its scaled mass would matter): lower time.mass_scale")));
  EXPECT_THAT(make_plan(cheap_paper_scene({"flow.compliance=1e-13 m3/Pa", "drag.velocity=mixture"})).drive_notes,
              Contains(HasSubstr("flow.compliance relaxes in C (Delta p0 + pack)")));
}

TEST(Dimensionless, AdhesionOverDrag) {
  // 1.5 pi 1e-3 x 8.25e-6 = 3.8877e-8 N over 5.5983e-7 x 5e-3 = 2.79915e-9 N
  EXPECT_NEAR(adhesion_number(jkr_pull_off(1e-3, 8.25e-6), paper, 5e-3), 13.889, 1e-3);
}

TEST(Dimensionless, Tabor) {
  // (8.25e-6 x 1e-6 / (2.920681e12 x 4.492125e-30))^(1/3) = 628808^(1/3)
  EXPECT_NEAR(tabor_number(1e-3, 1.709e6, 8.25e-6), 85.672, 1e-3);
  // (1e-8 x 1e-2 / (1.6e21 x 4.492125e-30))^(1/3) = 0.0139133^(1/3)
  EXPECT_NEAR(tabor_number(0.1, 4e10, 1e-8), 0.24052, 1e-4);
}

TEST(Plan, AdvisesOnTheKeysOfTheLaw) {
  const auto hooke = warnings(make_plan(cheap_paper_scene({"contact.law=hooke", "contact.stiffness=1e-3 N/m"})));
  EXPECT_THAT(hooke, Contains(HasSubstr("(too soft below 30): raise contact.stiffness")));
  EXPECT_THAT(hooke, Not(Contains(HasSubstr("youngs_modulus"))));
  EXPECT_THAT(warnings(make_plan(cheap_paper_scene(
                  {"contact.law=jkr", "contact.surface_energy=1 mJ/m2", "contact.youngs_modulus=1e5 Pa"}))),
              Contains(HasSubstr("raise contact.youngs_modulus or lower contact.surface_energy")));
}

TEST(Plan, SaysThatARunWouldRefuseSoftSprings) {
  const Plan plan = make_plan(cheap_paper_scene({"contact.law=hooke", "contact.stiffness=1e-9 N/m"}));
  EXPECT_THAT(warnings(plan), Contains(HasSubstr("raise contact.stiffness or slow the flow")));
  EXPECT_EQ(plan.limits.rayleigh_time, 0);
  EXPECT_THAT(limit_words(plan.limits, plan.dt), AllOf(HasSubstr("dt/contact time"), Not(HasSubstr("Rayleigh"))));
}

TEST(Plan, InertialDragIsModelledByALawThatKnowsIt) {
  const Overrides fast{"drag.law=beetstra", "flow.mean_velocity=0.15 m/s"};
  const Plan plan = make_plan(cheap_paper_scene(fast));
  EXPECT_TRUE(term_named(plan, "inertial drag").modelled);
  EXPECT_THAT(warnings(plan), Contains(HasSubstr("but not modelled; inertial drag is")));
  EXPECT_GT(term_named(plan, "drag").value, term_named(make_plan(cheap_paper_scene()), "drag").value);
}

TEST(Plan, SaysWhoseRateTheFlowKeepsAndWhatThatLeavesOut) {
  const auto plan = [](const char* reading) {
    return make_plan(cheap_paper_scene({std::string("drag.velocity=") + reading}));
  };
  EXPECT_THAT(plan("interstitial").drag_note, HasSubstr("the liquid keeps the flow's rate, F = c (V0/eps - u)"));
  EXPECT_THAT(plan("mixture").drag_note, HasSubstr("liquid and particles together"));
  EXPECT_THAT(plan("superficial").drag_note, HasSubstr("c eps (V0/eps - u)"));
  for (const char* whole : {"interstitial", "mixture"}) EXPECT_THAT(warnings(plan(whole)), IsEmpty());
  // 1 - 0.55
  EXPECT_THAT(warnings(plan("superficial")), Contains(HasSubstr("about 0.45 of the total force")));
  EXPECT_EQ(make_plan(cheap_paper_scene({"drag.enabled=false"})).drag_note, "");
}

TEST(Plan, WeighsAdhesion) {
  const auto sticky = [](const char* law) {
    return make_plan(cheap_paper_scene({std::string("contact.law=") + law, "contact.surface_energy=1 mJ/m2"}));
  };
  const Plan jkr = sticky("jkr"), dmt = sticky("dmt");
  // Of the drag at the neck's 20 mm/s, a quarter of Dimensionless.AdhesionOverDrag.
  EXPECT_NEAR(term_named(jkr, "adhesion").value, 3.4722, 1e-3);
  EXPECT_NEAR(term_named(dmt, "adhesion").value, 4.6297, 1e-3);
  EXPECT_TRUE(term_named(jkr, "adhesion").needed);
  // What would matter where nothing sticks: 1 mJ/m2 / 3.4722.
  const PlannedTerm without = term_named(make_plan(cheap_paper_scene()), "adhesion");
  EXPECT_NEAR(without.value, 2.88e-4, 1e-6);
  EXPECT_FALSE(without.needed || without.modelled);
  EXPECT_GT(term_named(jkr, "law of adhesion").value, 5);
  EXPECT_EQ(jkr.law_note, "");
  EXPECT_THAT(warnings(dmt), Contains(HasSubstr("contact.law = \"jkr\" fits")));
}

TEST(Plan, SharesOfTheCostAreThoseOfTheTermsThatTheSceneHas) {
  const Plan with = make_plan(cheap_paper_scene()),
             without = make_plan(cheap_paper_scene({"lubrication.enabled=false"}));
  const double share = term_named(with, "lubrication").share;
  EXPECT_GT(share, 0.1);
  EXPECT_EQ(term_named(without, "lubrication").share, 0);
  EXPECT_NEAR(without.instructions / with.instructions, 1 - share, 1e-9);
  double sum = 0;
  for (const PlannedTerm& term : with.terms) sum += term.share;
  EXPECT_LT(sum, 1);
}

TEST(Plan, KnowsTheFrictionOfSpecies) {
  const std::string common = R"(particles.species=[{diameter="33 um",share=0.5},{diameter="33 um",share=0.5)";
  const Overrides frictionless = {"contact.friction.sliding=0", "contact.friction.rolling=0",
                                  "contact.friction.torsion=0"};
  const auto plan_of = [&](const std::string& second) {
    Overrides all = frictionless;
    all.push_back(common + second + "}]");
    return make_plan(cheap_paper_scene(all));
  };
  const Plan rough = plan_of(",friction={sliding=0.5,rolling=0.2}"), smooth = plan_of("");
  EXPECT_EQ(term_named(rough, "sliding friction").value, 0.5);
  EXPECT_TRUE(term_named(rough, "sliding friction").modelled);
  EXPECT_FALSE(term_named(smooth, "sliding friction").modelled);
  EXPECT_EQ(term_named(rough, "rolling friction").value, 0.2);
  EXPECT_FALSE(term_named(rough, "torsion friction").modelled);
  EXPECT_EQ(term_named(rough, "friction of species").value, 0);
  EXPECT_THAT(term_named(rough, "friction of species").reason,
              HasSubstr("mu between particles 0 to 0.5, with walls 0 to 0.5"));
  EXPECT_GT(term_named(rough, "friction of species").share, 0);
  EXPECT_EQ(std::ranges::find(smooth.terms, "friction of species", &PlannedTerm::term), smooth.terms.end());
}

TEST(Plan, CostGrowsWithStepsAndWithTheWayOfOneStep) {
  const Scene scene = cheap_paper_scene();
  const double still = instructions_per_particle_step(scene, 0), moving = instructions_per_particle_step(scene, 1e-3);
  EXPECT_GT(moving, still);
  EXPECT_DOUBLE_EQ(instructions_per_particle_step(scene, 2e-3) - moving, moving - still);
  const Plan plan = make_plan(scene), longer = make_plan(cheap_paper_scene({"time.end=2 s"}));
  EXPECT_GT(longer.instructions, plan.instructions);
  EXPECT_DOUBLE_EQ(plan.seconds(1e9), 2 * plan.seconds(2e9));
}

TEST(Plan, SaysHowFarTheNeckIsFelt) {
  // W / (2 pi) ln 100 with W = 400 um; and 0.034 / 1.18 of Re = 1062 x 0.02 x 1e-4 / 1.8e-3 = 1.18.
  const Plan plan = make_plan(cheap_paper_scene({"flow.source=openfoam"}));
  EXPECT_NEAR(plan.grid_reach, 2.9317e-4, 1e-7);
  EXPECT_NEAR(plan.scaling_error, 0.034, 1e-4);
}

TEST(MachineSpeed, IsMeasured) {
  const double speed = instructions_per_second(0);
  EXPECT_GT(speed, 0);
  EXPECT_TRUE(std::isfinite(speed));
}

TEST(Plan, KnowsUnequalSizes) {
  const Plan equal = make_plan(cheap_paper_scene());
  EXPECT_EQ(equal.sizes_note, "");
  const Plan mixed = make_plan(
      cheap_paper_scene({R"(particles.species=[{diameter="25 um",share=0.5},{diameter="35 um",share=0.5}])"}));
  EXPECT_THAT(mixed.sizes_note, HasSubstr("diameters from 25 um to 35 um (ratio 1.4) in 2 kinds: number mean 30 um"));
  // (25^3 + 35^3) / (25^2 + 35^2)
  EXPECT_THAT(mixed.sizes_note, HasSubstr("Sauter mean 31.62 um"));
  // As many spheres of the mean volume as fit: 33^3 / 29250.
  EXPECT_NEAR(mixed.particles / equal.particles, 35937.0 / 29250, 1e-6);
  EXPECT_LT(mixed.dt, equal.dt);
}

TEST(Plan, WarnsOfCrystalsUntilSizesDiffer) {
  const auto note = [](const Overrides& overrides) {
    Overrides all{"particles.diameter=50 um", "geometry.channel_length=1 mm"};
    all.insert(all.end(), overrides.begin(), overrides.end());
    return make_plan(cheap_paper_scene(all)).layers_note;
  };
  EXPECT_THAT(note({}), HasSubstr("holds 2 whole layers"));
  EXPECT_THAT(note({"particles.size_spread=0.03"}), HasSubstr("a spread of sizes of 0.08 and more"));
  EXPECT_EQ(note({"particles.size_spread=0.1"}), "");
}

// Twenty seeds of scenes/campaign.toml, which rewinds, took 0.0440 s a burst at D/d = 2.13.
TEST(Plan, SaysWhatABurstOfARewindCosts) {
  const ExpectedBurst burst = make_plan(cheap_paper_scene({"geometry.channel_length=500 um", "inlet.start=flowing",
                                                           "unclog.protocol=rewind", "particles.diameter=47 um"}))
                                  .burst;
  EXPECT_EQ(burst.unknown, "");
  EXPECT_NEAR(burst.simulated(), 0.0440, 0.05 * 0.0440);
}

// Restarts of scenes/campaign.toml with 5 D of channel took 0.104 to 0.108 s a burst at D/d = 2.13 (48 and 445 bursts)
// and 0.111 s at 2.5 (324 bursts).
TEST(Plan, SaysWhatABurstCosts) {
  const Overrides neck = {"geometry.channel_length=500 um", "inlet.start=flowing", "unclog.protocol=restart"};
  const auto burst = [&](Overrides more) {
    more.insert(more.end(), neck.begin(), neck.end());
    return make_plan(cheap_paper_scene(more)).burst;
  };
  const ExpectedBurst at_47 = burst({"particles.diameter=47 um"}), at_40 = burst({"particles.diameter=40 um"});
  EXPECT_EQ(at_47.unknown, "");
  EXPECT_NEAR(at_47.mean, 8.4, 0.01);
  EXPECT_NEAR(at_47.simulated(), 0.107, 0.05 * 0.107);
  EXPECT_NEAR(at_40.mean, 11.8, 0.01);
  EXPECT_NEAR(at_40.simulated(), 0.111, 0.05 * 0.111);
  // Half way between the two sizes of the map in D/d the mean is the geometric one.
  EXPECT_NEAR(burst({"particles.diameter=43.215 um"}).mean, std::sqrt(8.4 * 11.8), 0.02);
  // (1.96 * 0.48 / 0.05)^2 = 354.04
  EXPECT_EQ(bursts_for(at_47.spread, 0.05), 355);
  // Twice as fast: half the time.
  EXPECT_NEAR(burst({"particles.diameter=47 um", "flow.mean_velocity=10 mm/s"}).simulated(), at_47.simulated() / 2,
              1e-9);
}

TEST(Plan, SaysWhereNobodyMeasuredABurst) {
  const auto unknown = [](Overrides more) {
    more.insert(more.end(), {"inlet.start=flowing"});
    return make_plan(cheap_paper_scene(more)).burst.unknown;
  };
  EXPECT_THAT(unknown({"unclog.protocol=restart", "contact.friction.sliding=0.45"}),
              HasSubstr("friction 0.45, 0.6, 0.6 (sliding, rolling, torsion) is not on the map"));
  EXPECT_THAT(unknown({"unclog.protocol=stop", "particles.diameter=20 um"}), HasSubstr("not at 5"));
  EXPECT_THAT(unknown({"unclog.protocol=release"}), HasSubstr("neither \"restart\", \"rewind\" nor \"stop\""));
  EXPECT_THAT(unknown({"unclog.protocol=stop", "contact.friction.rolling=0", "contact.friction.torsion=0"}),
              HasSubstr("only 1 of 6 seeds of the map clogged: <s> is above"));
  EXPECT_THAT(unknown({"unclog.protocol=stop", "geometry.half_angle=45 deg"}), HasSubstr("narrows at 60 deg"));
}

}  // namespace
}  // namespace clogflow::test
