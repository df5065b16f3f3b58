// The protocols as machines of states, fed with made-up times and clogs.
#include <gtest/gtest.h>

#include "dem/protocol/clog_watch.hpp"
#include "tests/coupling/scene/scene_texts.hpp"

namespace clogflow {
namespace {

using Action = ClogWatch::Action;

Scene release_scene() {
  return parse_scene(
      channel, "release",
      {"unclog.protocol=release", "unclog.after=30 ms", "unclog.duration=2 ms", "unclog.shortcut=false"});
}

const auto at_rest = [] { return ClogState{0, 0, 0}; };
const auto moving = [] { return ClogState{1e-3, 1e-3, 0}; };
const auto never = []() -> ClogState {
  ADD_FAILURE() << "looked at the particles without need";
  return {};
};

const auto not_proved = [] { return false; };
const auto proved = [] { return true; };

Scene scene_with(UnclogProtocol protocol) {
  Scene s = release_scene();
  s.unclog.protocol = protocol;
  s.unclog.shortcut = true;
  return s;
}

/// Nothing ever left, and no rest is proved.
template <class State>
Action act(ClogWatch& watch, double time, State&& state) {
  return watch.act(time, 0, state, not_proved);
}

TEST(ClogWatch, WithoutProtocolDoesNothing) {
  ClogWatch watch(scene_with(UnclogProtocol::none));
  EXPECT_EQ(act(watch, 10, never), Action::none);
}

TEST(ClogWatch, ReleasesAfterTheWaitAndEndsAfterTheDuration) {
  ClogWatch watch(release_scene());
  EXPECT_EQ(act(watch, 0.029, never), Action::none);
  EXPECT_EQ(act(watch, 0.0301, at_rest), Action::friction_off);
  EXPECT_TRUE(watch.friction_off());
  EXPECT_EQ(act(watch, 0.0320, never), Action::none);
  EXPECT_EQ(act(watch, 0.0322, never), Action::friction_on);
  EXPECT_FALSE(watch.friction_off());
  // The wait begins again when friction is back.
  EXPECT_EQ(act(watch, 0.0621, never), Action::none);
  EXPECT_EQ(act(watch, 0.0623, at_rest), Action::friction_off);
}

TEST(ClogWatch, APassageStartsTheWaitAgain) {
  ClogWatch watch(release_scene());
  watch.passed(0.02);
  EXPECT_EQ(act(watch, 0.0499, never), Action::none);
  EXPECT_EQ(act(watch, 0.0501, at_rest), Action::friction_off);
}

TEST(ClogWatch, WaitsForRestAndLooksOnlyNowAndThen) {
  ClogWatch watch(release_scene());
  EXPECT_EQ(act(watch, 0.031, moving), Action::none);
  // A tenth of tau = 0.66 ms between two looks.
  EXPECT_EQ(act(watch, 0.0316, never), Action::none);
  EXPECT_EQ(act(watch, 0.0317, at_rest), Action::friction_off);
}

TEST(ClogWatch, GoesOnAtOnceWhenRestIsProved) {
  ClogWatch watch(scene_with(UnclogProtocol::release));
  // Half of tau = 6.6 ms is always waited for.
  EXPECT_EQ(watch.act(0.0032, 0, never, proved), Action::none);
  EXPECT_EQ(watch.act(0.0034, 0, never, proved), Action::friction_off);
  EXPECT_TRUE(watch.proved());
}

TEST(ClogWatch, WaitsAllTheSameWithoutTheShortcut) {
  ClogWatch watch(release_scene());
  const auto not_asked = [] {
    ADD_FAILURE() << "asked for a proof";
    return true;
  };
  EXPECT_EQ(watch.act(0.0299, 0, never, not_asked), Action::none);
  EXPECT_EQ(watch.act(0.0306, 0, at_rest, not_asked), Action::friction_off);
}

TEST(ClogWatch, StopEndsTheRunOnce) {
  ClogWatch watch(scene_with(UnclogProtocol::stop));
  EXPECT_FALSE(watch.stopped());
  EXPECT_EQ(watch.act(0.01, 0, never, proved), Action::stop);
  EXPECT_TRUE(watch.stopped());
  EXPECT_EQ(watch.act(1, 0, never, proved), Action::none);
}

TEST(ClogWatch, StopWithoutAProofWaitsFourTimesAsLong) {
  ClogWatch watch(scene_with(UnclogProtocol::stop));
  EXPECT_EQ(act(watch, 0.119, never), Action::none);
  EXPECT_EQ(act(watch, 0.1201, at_rest), Action::stop);
  EXPECT_FALSE(watch.proved());
}

TEST(ClogWatch, ARestartLastsUntilItsStrainHasPassed) {
  Scene s = scene_with(UnclogProtocol::restart);
  s.unclog.strain = 1;  // D^3 over pi d^3 / 6 at 33 um: 53.1 particles
  ClogWatch watch(s);
  EXPECT_EQ(watch.act(0.01, 100, never, proved), Action::friction_off);
  EXPECT_EQ(watch.act(0.02, 152, never, proved), Action::none);
  EXPECT_EQ(watch.act(0.03, 153, never, proved), Action::friction_on);
}

TEST(ClogWatch, ARestartThatStandsIsGivenUp) {
  Scene s = scene_with(UnclogProtocol::restart);
  s.unclog.strain = 1;  // the flow carries D^3 in D / 4 v = 5 ms; ten times that and 20 tau are 0.182 s
  ClogWatch watch(s);
  EXPECT_EQ(watch.act(0.01, 0, never, proved), Action::friction_off);
  EXPECT_EQ(watch.act(0.191, 0, never, proved), Action::none);
  EXPECT_EQ(watch.act(0.193, 0, never, proved), Action::friction_on);
}

TEST(ClogWatch, PokesOnceAClog) {
  ClogWatch watch(scene_with(UnclogProtocol::poke));
  EXPECT_EQ(watch.act(0.01, 0, never, proved), Action::poke);
  EXPECT_TRUE(watch.pokes());
  watch.poked(5);
  EXPECT_FALSE(watch.pokes() || watch.friction_off());
  EXPECT_EQ(watch.taken_out(), 5);
  EXPECT_EQ(watch.act(0.0132, 0, never, proved), Action::none);
  EXPECT_EQ(watch.act(0.0134, 0, never, proved), Action::poke);
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
