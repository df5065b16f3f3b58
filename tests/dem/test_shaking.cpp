// A pack whose step is too long shakes from one step to the next: what a run then sees, says and writes down.
#include <gmock/gmock.h>

#include "tests/dem/laboratory.hpp"

namespace clogflow::test {
namespace {

using testing::Contains;
using testing::HasSubstr;

/// A sphere pressed on a floor of friction and pushed a little, at a share of the largest step of its contact.
struct Pressed {
  std::vector<Particle> sphere{
      {.radius = 16.5e-6, .x = -1e-4, .z = 16.4e-6, .vx = 1e-6, .wx = 0.3, .wy = 0.1, .wz = 0.2}};
  Scene scene = laboratory_scene({3e6, 0.35, 1062, 33e-6}, 1e-8);

  explicit Pressed(double share) {
    scene.contact.restitution = 0.7;
    set_friction(scene, {0.6, 0.6, 0.6});
    set_floor(scene, 1e-3);
    scene.body_force = {0, 0, -1e-7};
    scene.flow.source = FlowSource::uniform;
    scene.flow.velocity = {1e-2, 0, 0};  // so that less than 1e-5 m/s is rest
    scene.time.allow_unstable = true;
    scene.time.step = share * at_rest_limit();
    scene.time.end = 20000 * scene.time.step;
    scene.output.series_interval = scene.time.end;
  }

private:
  double at_rest_limit() const {
    Laboratory lab(scene, sphere);
    for (int k = 0; k < 20000; ++k) lab->compute_forces(), lab->advance();
    lab->compute_forces();
    const NetworkLimit network = lab->network();
    return network.exact(network.bound());
  }
};

struct Outcome {
  RunData run;
  std::vector<std::string> notes;
};

Outcome outcome(double share) {
  const Pressed pressed(share);
  Laboratory lab(pressed.scene, pressed.sphere);
  Outcome outcome;
  lab->on_note([&](const std::string& note) { outcome.notes.push_back(note); });
  outcome.run = lab->run();
  return outcome;
}

TEST(Shaking, AboveTheLimitIsSeenBetweenWholeSteps) {
  // Torsion is the first to go: the sphere turns to and fro on its spot.
  const auto [run, notes] = outcome(1.2);
  EXPECT_THAT(notes, Contains(HasSubstr("the pack shakes: near the neck particles go or turn to and fro at")));
  EXPECT_GT(run.record.shaking_speed.value(), 1e-5);
  const auto& spin = run.snapshots.back().spin;
  EXPECT_LT(16.5e-6 * std::hypot(spin[0], spin[1], spin[2]), 1e-5);
}

// The motion is chaotic, so the whole-step speed is bounded loosely: it is some tenth of the other.
TEST(Shaking, FarAboveTheLimitSpeedsOfTheSeriesShowIt) {
  for (const double share : {2.1, 2.2, 2.3}) {
    const auto [run, notes] = outcome(share);
    EXPECT_GT(run.series.median_speed.back(), 1e-5);
    const auto& velocity = run.snapshots.back().velocity;
    EXPECT_LT(std::hypot(velocity[0], velocity[1], velocity[2]), 0.5 * run.series.median_speed.back()) << share;
  }
}

TEST(Shaking, BelowTheLimitThereIsNone) {
  const auto [run, notes] = outcome(0.9);
  EXPECT_THAT(notes, Not(Contains(HasSubstr("shakes:"))));
  EXPECT_EQ(run.record.shaking_speed.value(), 0.0);
  EXPECT_LT(run.series.median_speed.back(), 1e-5);
}

}  // namespace
}  // namespace clogflow::test
