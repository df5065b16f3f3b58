// What a run refuses or reports: each message read.
#include <fstream>

#include <gmock/gmock.h>

#include "dem/run/model.hpp"
#include "tests/coupling/refusal.hpp"
#include "tests/dem/channel_scene.hpp"

namespace clogflow::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(BlowUp, NamesStepParticleForceAndKnob) {
  // A step a hundred times too long for two spheres deep in each other.
  Laboratory lab(laboratory_scene({3e9, 0.35, 1062, 33e-6}, 1e-5),
                 {{.radius = 16.5e-6}, {.radius = 16.5e-6, .x = 30e-6}});
  EXPECT_THAT(
      refusal([&] { lab.run_until(1e-3); }),
      AllOf(HasSubstr("blow-up at step "), HasSubstr("particle "), HasSubstr("m/s under a force of "),
            HasSubstr(", largest overlap 3e-06 m; "), HasSubstr("lower time.step or raise contact.youngs_modulus")));
}

TEST(BlowUp, NamesTheParticleThatIsDeepest) {
  Laboratory lab(laboratory_scene({3e9, 0.35, 1062, 33e-6}, 1e-9),
                 {{.radius = 16.5e-6, .x = 1e-3, .vx = 0.1}, {.radius = 16.5e-6}, {.radius = 16.5e-6, .x = 50e-6}});
  lab->particles()[2].x = 5e-6;
  EXPECT_THAT(refusal([&] { lab.step(); }),
              AllOf(HasSubstr("pressed too deep: particle 1 at (0, 0, 0) m"),
                    HasSubstr("particle 1 at (0, 0, 0) m overlaps particle 2 by 2.8e-05 m, 0.85 of its diameter; it "
                              "begins so: move particles apart")));
}

// 1e160 rad/s squared is beyond the range of a number: no such energy gets into a file.
TEST(BlowUp, AnEnergyThatIsNoNumberIsNotRecorded) {
  Laboratory lab(laboratory_scene({3e6, 0.35, 1062, 33e-6}, 1e-7),
                 {{.radius = 16.5e-6}, {.radius = 16.5e-6, .x = 1e-3}});
  lab.step();
  lab->particles()[1].wz = 1e170;
  EXPECT_THAT(refusal([&] {
                lab->compute_forces();
                while (lab->time() < 1) lab.step(), lab->record();
              }),
              HasSubstr("an energy is no number"));
}

TEST(InitialParticles, ThatTurnTooFarInAStepAreRefused) {
  const Scene scene = laboratory_scene({3e6, 0.35, 1062, 33e-6}, 1e-7);
  make_model(scene, nullptr, {{.radius = 16.5e-6, .wy = -9e6}});
  EXPECT_THAT(refusal([&] {
                make_model(scene, nullptr, {{.radius = 16.5e-6}, {.radius = 16.5e-6, .wy = -1.1e7}});
              }),
              HasSubstr("particle 2 of those given turns by 1.1 rad in a step of 1e-07 s (allowed 1 rad): lower its "
                        "spin or the step"));
}

std::vector<Particle> row_of(int count) {
  std::vector<Particle> row;
  for (int k = 0; k < count; ++k) row.push_back({.radius = 16.5e-6, .x = 1e-3 * k});
  return row;
}

TEST(BlowUp, IsSeenInTheStepOfTheFirstNaN) {
  Laboratory lab(laboratory_scene({3e6, 0.35, 1062, 33e-6}, 1e-7), row_of(11));
  lab.step();
  // In any lane of any vector, and whatever fast or slow particles come after it.
  lab->particles()[2].vy = std::nan("");
  lab->particles()[9].vx = 1e-3;
  EXPECT_THAT(refusal([&] { lab.step(); }), AllOf(HasSubstr("blow-up at step 1"), HasSubstr("moves at nan m/s"),
                                                  HasSubstr("a number became infinite or none")));
}

TEST(LostParticle, NamesTheParticleAndThePlace) {
  Scene s = laboratory_scene({1e6, 0.3, 1000, 0.1}, 0.01);
  set_floor(s, 2);
  Laboratory lab(s, {{.radius = 0.05, .z = 0.5}, {.radius = 0.05, .x = 0.5, .z = 0.5}});
  lab->particles()[1].x = 5;
  EXPECT_THAT(
      refusal([&] { lab->compute_forces(); }),
      AllOf(HasSubstr("particle 1 left the walls, which reach from (-1, -1, 0) to (1, 1, 2) m, at (5, 0, 0.5) m"),
            HasSubstr("lower time.step or raise contact.youngs_modulus")));
}

TEST(Flow, OfAnotherSceneIsRefusedWithTheFirstDifference) {
  const Scene narrow = short_channel_scene();
  const FlowGrid grid = synthetic_flow(short_channel_scene({"geometry.half_angle=45 deg"}));
  EXPECT_THAT(
      refusal([&] { make_model(narrow, &grid, {}); }),
      AllOf(HasSubstr("the flow file belongs to another scene (geometry.half_angle = \"45 deg\", this scene has "
                      "geometry.half_angle = \"60 deg\")"),
            HasSubstr("make it anew with clog case and clog map")));
}

TEST(Flow, ThatIsMissingIsAskedFor) {
  EXPECT_THAT(refusal([] { make_fluid(short_channel_scene(), nullptr); }),
              HasSubstr("flow.source = \"openfoam\" needs the flow: give --flow flow.h5"));
}

TEST(Step, OfASceneWhereNothingMovesIsAskedFor) {
  Scene s = laboratory_scene({}, 1e-6);
  s.time.step = 0;
  EXPECT_THAT(refusal([&] { make_model(s, nullptr, {}); }),
              AllOf(HasSubstr("time.step is missing"), HasSubstr("give time.step")));
}

TEST(Porosity, OfOverlappingParticlesIsRefused) {
  PorosityStrips strips(0, 1, {1});
  Particles p;
  for (int k = 0; k < 2; ++k) p.add({.radius = 0.49, .x = 0.5});
  EXPECT_THAT(refusal([&] { strips.update(p); }),
              AllOf(HasSubstr("in strip 1 of 1"), HasSubstr("raise contact.youngs_modulus")));
}

}  // namespace
}  // namespace clogflow::test
