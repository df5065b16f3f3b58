// The step limits of a scene: what is refused, warned of and said, and what runs do near them.
#include <gmock/gmock.h>

#include "coupling/base/source_folder.hpp"
#include "dem/physics/drag_law.hpp"
#include "dem/stability/step_limit.hpp"
#include "dem/stability/step_watch.hpp"
#include "tests/coupling/refusal.hpp"
#include "tests/dem/laboratory.hpp"

namespace clogflow::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// A sphere on a floor under ten times a settling force.
Scene pressed(double step) {
  Scene s = laboratory_scene({3e6, 0.35, 1062, 33e-6}, step);
  s.contact.restitution = 0.7;
  set_friction(s, {0.6, 0.6, 0.6});
  set_floor(s, 1e-3);
  s.body_force = {0, 0, -1e-7};
  s.time.end = 3000 * step;
  return s;
}

TEST(StepLimits, AreNamedRefusedAndWarnedOf) {
  const std::vector<Particle> one{{.radius = 16.5e-6, .z = 16.5e-6}};
  const Model model = make_model(pressed(1e-8), nullptr, one);
  const StepLimits limits = expected_limits(model, one);
  EXPECT_THAT(limit_words(limits, model.dt),
              AllOf(HasSubstr("dt = 1e-08 s"), HasSubstr("dt/Rayleigh"), HasSubstr("dt/contact limit")));
  EXPECT_EQ(check_step(limits, model), "");
  const auto at = [&](double share) { return make_model(pressed(share * limits.contacts), nullptr, one); };
  EXPECT_THAT(check_step(limits, at(0.95)), HasSubstr("is near the limit of the contacts"));
  EXPECT_THAT(refusal([&] { check_step(limits, at(1.1)); }),
              AllOf(HasSubstr("is unstable: the contacts allow"), HasSubstr("lower time.step or ")));
}

TEST(StepLimits, AShareOfTheContactsLimitShortensTheStepOnly) {
  const std::vector<Particle> one{{.radius = 16.5e-6, .z = 16.5e-6}};
  Scene s = pressed(1e-8);
  s.time.step = 0;
  s.flow.source = FlowSource::uniform;
  s.flow.velocity = {0, 0, -1e-3};
  s.time.end = 1;
  s.time.step_fraction = 1;
  const double limit = expected_limits(make_model(s, nullptr, one), one).contacts;
  s.time.contact_limit_share = 0.7;
  const Model model = make_model(s, nullptr, one);
  // The step divides the time: a millionth shorter at most.
  EXPECT_NEAR(model.dt, 0.7 * limit, 1e-5 * limit);
  EXPECT_LE(model.dt, 0.7 * limit);
  s.time.step_fraction = 0.1 * limit / model.contact_time;
  EXPECT_NEAR(make_model(s, nullptr, one).dt, 0.1 * limit, 1e-5 * limit);
}

/// Limit of a rough and a smooth sphere that touch and, of the rough one alone, the floor.
double limit_of_species(double smooth_friction, double floor_friction) {
  Scene s = pressed(1e-9);
  s.particles.species = {{.diameter = 33e-6, .share = 0.5, .density = 1062},
                         {.diameter = 33e-6, .share = 0.5, .density = 1062}};
  const double smooth = smooth_friction, floor = floor_friction;
  s.particles.species[0].friction = {0.6, 0.6, 0.6}, s.particles.species[0].wall_friction = {floor, floor, floor};
  s.particles.species[1].friction = {smooth, smooth, smooth}, s.particles.species[1].wall_friction = {0, 0, 0};
  Simulation run(s, nullptr, 1,
                 {{.species = 0, .radius = 16.5e-6, .z = 16.49e-6}, {.species = 1, .radius = 16.5e-6, .z = 49.4e-6}});
  run.fill({});
  run.compute_forces();
  return run.network().bound().step;
}

TEST(StepLimits, ContactsOfASmoothSpeciesHaveNoSpringsOfFriction) {
  // Torsion at the floor limits where there is friction, else that between the two, else the normal springs.
  const double all = limit_of_species(0.6, 0.6), between = limit_of_species(0.6, 0), none = limit_of_species(0, 0);
  EXPECT_LT(1.05 * all, between);
  EXPECT_LT(1.05 * between, none);
  // 2 / omega of the faster mode of two masses on Hertz' tangents, their dashpots left out: these shorten it.
  const double own = 3e6 / (2 * (1 - 0.35 * 0.35)), r = 16.5e-6, m = 1062 * 4 / 3 * M_PI * r * r * r;
  const double floor = 2 * own * std::sqrt(r * 0.01e-6), pair = 2 * own * std::sqrt(r / 2 * 0.09e-6);
  const double sum = (floor + 2 * pair) / m, square = floor * pair / (m * m);
  const double undamped = 2 / std::sqrt(sum / 2 + std::sqrt(sum * sum / 4 - square));
  EXPECT_LT(none, undamped);
  EXPECT_GT(none, 0.6 * undamped);
}

/// A sphere squeezed by the six walls of a box that is too small for it: only its contacts know the limit.
struct Deep {
  std::vector<Particle> sphere{{.radius = 16.5e-6}};
  Scene scene = pressed(1e-8);
  StepLimits limits = expected_limits(make_model(scene, nullptr, sphere), sphere);

  explicit Deep(double share) {
    scene.box.min.fill(-15e-6);
    scene.box.max.fill(15e-6);
    scene.time.step = share * limits.contacts;
    scene.time.end = 2 * scene.time.step;
  }
};

TEST(StepLimits, AMessageNamesTheKeyThatDecidesTheStep) {
  const auto key = [](const Overrides& overrides) -> std::string {
    return make_model(read_scene(source_folder() / "scenes/paper.toml", overrides), nullptr, {}).step_key();
  };
  EXPECT_EQ(key({"time.step_fraction=0.02"}), "time.step_fraction");
  EXPECT_EQ(key({"time.step_fraction=0.02", "time.contact_limit_share=0.9"}), "time.step_fraction");
  EXPECT_EQ(key({"time.step_fraction=1", "time.contact_limit_share=0.7"}), "time.contact_limit_share");
  EXPECT_EQ(make_model(pressed(1e-8), nullptr, {{.radius = 16.5e-6, .z = 16.5e-6}}).step_key(),
            std::string("time.step"));
}

TEST(StepLimits, ARunThatBeginsAboveTheLimitOfItsContactsIsRefused) {
  const Deep deep(0.8);
  Laboratory lab(deep.scene, deep.sphere);
  EXPECT_THAT(refusal([&] { lab->run(); }), AllOf(HasSubstr("is above the limit of the contacts of particle 0 at"),
                                                  HasSubstr("lower time.step or "), HasSubstr("time.allow_unstable")));
}

TEST(StepLimits, ARunThatAllowsUnstableStepsIsOnlyWarned) {
  Deep deep(0.8);
  deep.scene.time.allow_unstable = true;
  Laboratory lab(deep.scene, deep.sphere);
  std::vector<std::string> notes;
  lab->on_note([&](const std::string& note) { notes.push_back(note); });
  lab->run();
  EXPECT_THAT(notes, testing::Contains(HasSubstr("is above the limit of the contacts of particle 0 at")));
  const Model above = make_model(Deep(2).scene, nullptr, deep.sphere);
  EXPECT_THAT(refusal([&] { check_step(deep.limits, above); }), HasSubstr("is unstable"));
  deep.scene.time.step = above.dt;
  EXPECT_THAT(check_step(deep.limits, make_model(deep.scene, nullptr, deep.sphere)), HasSubstr("is unstable"));
}

TEST(StepLimits, OfStiffDragPointToTheImplicitIntegrator) {
  Scene s = pressed(1e-6);
  s.drag.enabled = true;
  s.fluid.viscosity = 1;
  EXPECT_THAT(refusal([&] {
                const Model model = make_model(s, nullptr, {});
                check_step(expected_limits(model, {}), model);
              }),
              AllOf(HasSubstr("drag allows"), HasSubstr("implicit_drag")));
}

TEST(StepLimits, ASceneThatMustCrushItsParticlesIsRefused) {
  Scene s = pressed(1e-9);
  s.body_force = {0, 0, -1};
  EXPECT_THAT(refusal([&] {
                const Model model = make_model(s, nullptr, {});
                check_step(expected_limits(model, {}), model);
              }),
              AllOf(HasSubstr("overlaps of"), HasSubstr("raise contact.youngs_modulus")));
}

/// Largest and mean error of the restitution of head-on impacts, over the phases of the step.
std::pair<double, double> impact_errors(double share) {
  Scene s = laboratory_scene({3e6, 0.35, 1062, 33e-6}, 1e-8);
  s.contact.restitution = 0.7;
  const auto spheres = [](double gap) {
    return std::vector<Particle>{{.radius = 16.5e-6, .vx = 5e-3}, {.radius = 16.5e-6, .x = 33e-6 + gap}};
  };
  s.time.step = share * expected_limits(make_model(s, nullptr, spheres(0)), spheres(0)).impact;
  double worst = 0, mean = 0;
  constexpr int phases = 40;
  for (int k = 0; k < phases; ++k) {
    Laboratory lab(s, spheres((1 + (k + 0.5) / phases) * 5e-3 * s.time.step));
    for (bool met = false;;) {
      lab.step();
      if (met && lab->pair_tally().contacts == 0) break;
      met = met || lab->pair_tally().contacts > 0;
    }
    const double error = (lab.velocity(1) - lab.velocity(0)).x / 5e-3 / 0.7 - 1;
    worst = std::max(worst, std::abs(error));
    mean += error / phases;
  }
  return {worst, mean};
}

TEST(StepLimits, TheErrorOfSingleImpactsIsToldWhereItBegins) {
  StepLimits limits;
  limits.impact = 1;
  EXPECT_EQ(impact_warning(limits, 0.16), "");
  EXPECT_THAT(
      impact_warning(limits, 0.45),
      HasSubstr(
          "0.45 of the limit of two spheres that collide: the restitution of single impacts is off by up to 7.3 %"));
  limits.films_brake = true;
  EXPECT_EQ(impact_warning(limits, 0.45), "");
  for (const double share : {0.1, 0.2, 0.3, 0.45}) {
    const auto [worst, mean] = impact_errors(share);
    // It rises and falls with the number of steps in a contact.
    EXPECT_LT(worst, 1.5 * impact_error(limits, share) + 0.004) << share;
    EXPECT_GT(worst, 0.4 * impact_error(limits, share)) << share;
    EXPECT_LT(std::abs(mean), 0.01) << share;
  }
}

TEST(StepLimits, NoParticleMayGoFarInAStep) {
  Scene s = pressed(1e-7);
  s.body_force = {0, 0, 0};
  const auto at = [&](double speed) { return std::vector<Particle>{{.radius = 16.5e-6, .z = 5e-4, .vx = speed}}; };
  const auto check = [&](double speed) {
    const Model model = make_model(s, nullptr, at(speed));
    StepLimits limits = expected_limits(model, at(speed));
    limits.expected_overlap = 0;
    limits.contacts = 1;
    return check_step(limits, model) + passing_warning(limits, model.dt);
  };
  const double diameter_a_step = 33e-6 / 1e-7;
  EXPECT_EQ(check(0.09 * diameter_a_step), "");
  EXPECT_THAT(check(0.2 * diameter_a_step), HasSubstr("the fastest particles go 0.2 of a diameter"));
  EXPECT_THAT(refusal([&] { check(0.64 * diameter_a_step); }),
              HasSubstr("the fastest particles go 0.64 of a diameter (no more than 0.25, or contacts are met too "
                        "late): lower time.step"));
}

TEST(StepLimits, DeepOverlapsAreSaidOnceWithThePair) {
  const std::vector<Particle> two{{.radius = 16.5e-6, .z = 1e-4}, {.radius = 16.5e-6, .x = 33e-6, .z = 1e-4}};
  Scene s = pressed(1e-9);
  s.body_force = {0, 0, 0};
  Laboratory lab(s, two);
  lab->particles()[1].x = 28e-6;
  std::vector<std::string> notes;
  lab->on_note([&](const std::string& note) { notes.push_back(note); });
  lab.step(), lab.step();
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_THAT(notes[0], HasSubstr("by 5e-06 m, 0.15 of its diameter: beyond 0.1 of a diameter Hertz's law"));
}

TEST(StepLimits, ASphereWhoseCentreLiesOnAWallIsNotLetGo) {
  const std::vector<Particle> one{{.radius = 16.5e-6, .z = 1e-4}};
  Laboratory lab(pressed(1e-9), one);
  lab->particles()[0].z = 0;
  EXPECT_THAT(refusal([&] { lab.step(); }), HasSubstr("overlaps a wall by 1.65e-05 m, 0.5 of its diameter"));
}

TEST(StepWatch, SeesEnergyThatNothingSupplied) {
  StepWatch watch;
  EXPECT_FALSE(watch.appeared(1, 0));   // the first look
  EXPECT_FALSE(watch.appeared(10, 9));  // supplied
  EXPECT_FALSE(watch.appeared(11, 9));  // too little to tell
  EXPECT_FALSE(watch.appeared(5, 9));   // dissipated
  EXPECT_TRUE(watch.appeared(50, 9));
}

TEST(StepWatch, DoesNotChangeTheBitsOfARun) {
  const std::vector<Particle> few{{.radius = 16.5e-6, .z = 16e-6}, {.radius = 16.5e-6, .x = 33e-6, .z = 17e-6}};
  Laboratory watched(pressed(2e-8), few), unwatched(pressed(2e-8), few);
  watched->compute_forces(), unwatched->compute_forces();
  watched->network().bound();
  watched->advance(), unwatched->advance();
  EXPECT_EQ(watched.position(1), unwatched.position(1));
  EXPECT_EQ(watched.spin(1), unwatched.spin(1));
}

TEST(ExpectedLimits, OfAMixtureAreThoseOfASmallSphereAmongLargeOnes) {
  const auto limits = [](const Overrides& overrides) {
    Overrides all{"time.step=1 ns"};
    all.insert(all.end(), overrides.begin(), overrides.end());
    const Scene s = read_scene(source_folder() / "scenes" / "paper.toml", all);
    const Laws laws = make_laws(s);
    return expected_limits({.scene = s, .laws = laws, .contact_time = 0, .has_walls = false}, {});
  };
  const StepLimits small = limits({"particles.diameter=10 um", "particles.roughness=0.1 um"});
  const StepLimits mixed = limits({R"(particles.species=[{diameter="10 um",share=0.5},{diameter="30 um",share=0.5}])",
                                   "particles.roughness=0.1 um"});
  // A lone small sphere's drag; its film with a large one: R* = 3.75 in place of 2.5 um, 1 / m = 28/27 in place of 2.
  EXPECT_DOUBLE_EQ(mixed.drag, small.drag);
  EXPECT_NEAR(small.lubrication / mixed.lubrication, 3.75 * 3.75 / (2.5 * 2.5) * 28 / 27 / 2, 1e-9);
  // Among its like it bears (10 / 28)^2 of the drag of the mean 28 um, 0.36 of its own: the limit rises with the sixth
  // root, and large neighbours lower it.
  EXPECT_NEAR(mixed.contacts / small.contacts, 1, 0.2);
  EXPECT_DOUBLE_EQ(mixed.rayleigh_time, small.rayleigh_time);
}

TEST(ExpectedLimits, OfAMixtureAreThoseOfASmallSphereCaughtBetweenTwoLargeOnes) {
  const Scene s = read_scene(source_folder() / "scenes" / "paper.toml",
                             {R"(particles.species=[{diameter="4 um",share=0.95},{diameter="40 um",share=0.05}])",
                              "time.step=1 ns", "contact.friction.sliding=0", "contact.friction.rolling=0",
                              "contact.friction.torsion=0", "contact.restitution=1", "drag.velocity=interstitial"});
  const Laws laws = make_laws(s);
  const StepLimits limits = expected_limits({.scene = s, .laws = laws, .contact_time = 0, .has_walls = false}, {});
  // The large ones' load: the drag of 20 spheres of Sauter's mean in a pack of porosity 0.55, times (d / mean)^2.
  const double mean = (0.95 * 64 + 0.05 * 64000) / (0.95 * 16 + 0.05 * 1600) * 1e-6, v = s.flow.mean_velocity;
  const double load = 20 * find_drag_law("hoef").slow_factor(0.55) * 3 * M_PI * s.fluid.viscosity * mean * v / 0.55 *
                      std::pow(40e-6 / mean, 2);
  const double radius = 2e-6 * 20e-6 / 22e-6, nu = s.contact.poisson_ratio;
  const double modulus = s.contact.youngs_modulus / (2 * (1 - nu * nu));
  const double overlap = std::pow(3 * load / (4 * modulus * std::sqrt(radius)), 2.0 / 3);
  EXPECT_NEAR(limits.expected_overlap, overlap / 4e-6, 1e-3 * overlap / 4e-6);
  // Between two that hardly move: omega^2 = 2 k / m, k = 2 E* sqrt(R* delta); the limit 2 / omega.
  const double mass = s.particles.density * s.time.mass_scale * M_PI / 6 * std::pow(4e-6, 3);
  EXPECT_NEAR(limits.contacts, 2 / std::sqrt(2 * 2 * modulus * std::sqrt(radius * overlap) / mass),
              2e-3 * limits.contacts);
}

}  // namespace
}  // namespace clogflow::test
