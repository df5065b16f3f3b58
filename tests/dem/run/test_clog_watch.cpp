// The release protocol as a machine of states, fed with made-up times and clogs.
#include <gtest/gtest.h>

#include "dem/run/clog_watch.hpp"

namespace clogflow {
namespace {

using Action = ClogWatch::Action;

Scene release_scene() {
  return parse_scene(R"(
[geometry]
neck_width = "100 um"
half_angle = "60 deg"
[fluid]
viscosity = "1.8 mPa s"
density = "1062 kg/m3"
[flow]
mean_velocity = "5 mm/s"
[particles]
diameter = "33 um"
[contact]
youngs_modulus = "3 MPa"
poisson_ratio = 0.35
[unclog]
protocol = "release"
after = "30 ms"
duration = "2 ms"
[time]
end = "1 s"
)",
                     "release");
}

const auto at_rest = [] { return ClogState{0, 0, 0}; };
const auto moving = [] { return ClogState{1e-3, 1e-3, 0}; };
const auto never = []() -> ClogState {
  ADD_FAILURE() << "looked at the particles without need";
  return {};
};

TEST(ClogWatch, WithoutProtocolDoesNothing) {
  Scene s = release_scene();
  s.unclog.protocol = UnclogProtocol::none;
  ClogWatch watch(s);
  EXPECT_EQ(watch.act(10, never), Action::none);
}

TEST(ClogWatch, ReleasesAfterTheWaitAndEndsAfterTheDuration) {
  ClogWatch watch(release_scene());
  EXPECT_EQ(watch.act(0.029, never), Action::none);
  EXPECT_EQ(watch.act(0.0301, at_rest), Action::friction_off);
  EXPECT_TRUE(watch.friction_off());
  EXPECT_EQ(watch.act(0.0320, never), Action::none);
  EXPECT_EQ(watch.act(0.0322, never), Action::friction_on);
  EXPECT_FALSE(watch.friction_off());
  // The wait begins again when friction is back.
  EXPECT_EQ(watch.act(0.0621, never), Action::none);
  EXPECT_EQ(watch.act(0.0623, at_rest), Action::friction_off);
}

TEST(ClogWatch, APassageStartsTheWaitAgain) {
  ClogWatch watch(release_scene());
  watch.passed(0.02);
  EXPECT_EQ(watch.act(0.0499, never), Action::none);
  EXPECT_EQ(watch.act(0.0501, at_rest), Action::friction_off);
}

TEST(ClogWatch, WaitsForRestAndLooksOnlyNowAndThen) {
  ClogWatch watch(release_scene());
  EXPECT_EQ(watch.act(0.031, moving), Action::none);
  // A tenth of tau = 0.66 ms between two looks.
  EXPECT_EQ(watch.act(0.0316, never), Action::none);
  EXPECT_EQ(watch.act(0.0317, at_rest), Action::friction_off);
}

TEST(ClogState, SeesOnlyWhatIsNearTheNeckAndNotARattler) {
  Particles p;
  const auto add = [&](double x, double speed) { p.add({.radius = 16e-6, .x = x, .vx = speed}); };
  for (int k = 0; k < 19; ++k) add(-1e-5 * k, 1e-7);
  add(-2e-5, 3e-3);  // a rattler
  add(-8e-4, 5e-3);  // far upstream: the refilling does not matter
  add(9e-5, 2e-2);   // has passed
  const ClogState state = clog_state(p, release_scene());
  EXPECT_EQ(state.quantile_speed, 1e-7);
  EXPECT_EQ(state.largest_speed, 3e-3);
  EXPECT_EQ(state.position, 0);
}

TEST(ClogState, OfNothingIsAtRest) { EXPECT_EQ(clog_state({}, release_scene()).quantile_speed, 0); }

}  // namespace
}  // namespace clogflow
