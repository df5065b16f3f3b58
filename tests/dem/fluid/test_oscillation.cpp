// The prescribed factor on the flow: its values by hand, its way back against a sum over small steps, its tables.
#include <cmath>

#include <gmock/gmock.h>

#include "dem/fluid/flow_drive.hpp"
#include "dem/fluid/oscillation.hpp"
#include "tests/coupling/refusal.hpp"
#include "tests/dem/channel_scene.hpp"

namespace clogflow::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

Oscillation wave(double amplitude, OscillationShape shape = OscillationShape::sine, double phase = 0) {
  Scene scene;
  scene.flow.oscillation = {.amplitude = amplitude, .frequency = 50, .phase = phase, .shape = shape, .table = {}};
  return Oscillation(scene);
}

Oscillation of_table(const std::string& text) {
  const ScratchFile file(text);
  Scene scene;
  scene.flow.oscillation.table = file.name();
  return Oscillation(scene);
}

/// The longest way back, summed over small steps.
double summed_return(const Oscillation& oscillation, double end) {
  constexpr int steps = 200000;
  double longest = 0, now = 0;
  for (int k = 0; k < steps; ++k) {
    const double q = oscillation.factor((k + 0.5) * end / steps);
    now = q < 0 ? now - q * end / steps : 0;
    longest = std::max(longest, now);
  }
  return longest;
}

TEST(Oscillation, IsOffUnlessAsked) {
  EXPECT_FALSE(Oscillation(Scene{}).on());
  EXPECT_EQ(Oscillation(Scene{}).factor(3), 1);
  EXPECT_TRUE(Oscillation(Scene{}).is_steady(0));
}

TEST(Oscillation, SineByHand) {
  const Oscillation sine = wave(0.5);
  EXPECT_NEAR(sine.factor(0), 1, 1e-15);
  EXPECT_NEAR(sine.factor(0.005), 1.5, 1e-15);  // a quarter of 20 ms
  EXPECT_NEAR(sine.factor(0.015), 0.5, 1e-15);
  EXPECT_NEAR(sine.factor(10 + 0.02 / 12), 1.25, 1e-12);  // sin 30 deg
  EXPECT_NEAR(wave(0.5, OscillationShape::sine, 0.25).factor(0), 1.5, 1e-15);
  EXPECT_EQ(sine.largest(), 1.5);
  EXPECT_FALSE(sine.reverses());
  EXPECT_FALSE(sine.is_steady(1e9));
}

TEST(Oscillation, SquareByHand) {
  const Oscillation square = wave(0.25, OscillationShape::square);
  EXPECT_EQ(square.factor(0.0099), 1.25);
  EXPECT_EQ(square.factor(0.0101), 0.75);
  EXPECT_EQ(square.factor(0.0201), 1.25);
}

TEST(Oscillation, TableIsLinearAndHoldsItsEnds) {
  const Oscillation ramp = of_table("# a ramp\ntime [ms],factor\n0,0\n10,2\n\n20,1\n");
  EXPECT_EQ(ramp.factor(0), 0);
  EXPECT_DOUBLE_EQ(ramp.factor(0.005), 1);
  EXPECT_DOUBLE_EQ(ramp.factor(0.015), 1.5);
  EXPECT_EQ(ramp.factor(7), 1);
  EXPECT_EQ(ramp.largest(), 2);
  EXPECT_FALSE(ramp.is_steady(0.019));
  EXPECT_TRUE(ramp.is_steady(0.02));
  // From 0 to 2 in 10 ms, over 2 and 2 pi.
  EXPECT_NEAR(ramp.frequency(), 100 / (2 * M_PI), 1e-12);
}

TEST(Oscillation, LongestWayBackIsTheSum) {
  for (const double amplitude : {1.2, 3.0})
    for (const auto shape : {OscillationShape::sine, OscillationShape::square})
      EXPECT_NEAR(wave(amplitude, shape).longest_return() / summed_return(wave(amplitude, shape), 0.04), 1, 1e-4);
  EXPECT_EQ(wave(1).longest_return(), 0);
  const Oscillation table = of_table("time,factor\n0,1\n1,-1\n3,-2\n4,1\n5,-0.5\n6,1\n");
  // Triangles 0.5 x 1 / 2 and 2/3 x 2 / 2 about the trapezium 2 x 1.5.
  EXPECT_NEAR(table.longest_return(), 0.25 + 3 + 2.0 / 3, 1e-12);
  EXPECT_NEAR(table.longest_return(), summed_return(table, 6), 1e-4);
  EXPECT_TRUE(std::isinf(of_table("time,factor\n0,1\n1,-1\n").longest_return()));
}

TEST(Oscillation, RefusesDamagedTables) {
  const std::pair<const char*, const char*> cases[] = {
      {"", "no row (needs a header time,factor"},
      {"time,factor\n", "no row (needs a header time,factor"},
      {"0,1\n1,2\n", ":1: \"0,1\" (the header of a table of the flow is time,factor"},
      {"time [um],factor\n0,1\n", ":1: [um] (must be a unit of time, e.g. [ms])"},
      {"time,factor\n0,1\n1\n", ":3: 1 fields (must be two: a time and a factor)"},
      {"time,factor\n0,one\n", ":2: \"one\" is not a finite number"},
      {"time,factor\n0,nan\n", ":2: \"nan\" is not a finite number"},
      {"time,factor\n1,1\n", ":2: the first time is 1 s (must be 0)"},
      {"time,factor\n0,1\n2,1\n2,3\n", ":4: time 2 s (must be later than the row before, 2 s)"},
  };
  for (const auto& each : cases) EXPECT_THAT(refusal([&] { of_table(each.first); }), HasSubstr(each.second));
  // Of a file that is no table a message quotes a line's worth, without what would steer a terminal.
  const std::string junk = refusal([] { of_table(("\x1b[2J" + std::string(100'000, 'x')).c_str()); });
  EXPECT_THAT(junk, HasSubstr("header of a table"));
  EXPECT_LT(junk.size(), 500u);
  EXPECT_EQ(junk.find('\x1b'), std::string::npos);
}

void look_at_return(const Overrides& more) {
  Overrides all = {"unclog.protocol=none"};
  all.insert(all.end(), more.begin(), more.end());
  const Scene scene = short_channel_scene(all);
  check_return(scene, Oscillation(scene));
}

std::string refused(const Overrides& more) {
  return refusal([&] { look_at_return(more); });
}

TEST(Return, NeedsAChannelBehindTheNeck) {
  const std::string back = "flow.oscillation.amplitude=1.5", often = "flow.oscillation.frequency=50 Hz";
  EXPECT_THAT(refused({back, often}),
              AllOf(HasSubstr("flow.oscillation.amplitude = 1.5 (the flow goes back, but particles that left at the "
                              "end of the neck are gone"),
                    HasSubstr("geometry.expansion_width")));
  const std::string wide = "geometry.expansion_width=400 um", room = "geometry.expansion_length=400 um";
  EXPECT_NO_THROW(look_at_return({back, often, wide, room}));
  EXPECT_THAT(refused({back, often, wide, room, "unclog.protocol=release"}),
              HasSubstr("set unclog.protocol = \"none\""));
  EXPECT_THAT(refused({back, often, wide, room, "inlet.start=empty", "inlet.concentration=0.02"}),
              HasSubstr("(the flow goes back through the inlet"));
  // (3 cos(42 deg) - 96 deg) / pi = 0.18 s of 2e-10 m3/s go back, of the 1.8e-11 m3 behind the neck.
  EXPECT_THAT(refused({back, "flow.oscillation.frequency=0.5 Hz", wide, room}),
              AllOf(HasSubstr("more than half of the"), HasSubstr("raise geometry.expansion_length")));
  EXPECT_NO_THROW(look_at_return({"flow.oscillation.amplitude=1", often}));
}

TEST(FlowDrive, CountsWhatTheFlowCarries) {
  Scene scene;
  scene.flow.oscillation = {.amplitude = 3, .frequency = 1, .phase = 0, .shape = OscillationShape::square, .table = {}};
  FlowDrive drive(scene);
  drive.prescribe(0, false);
  EXPECT_EQ(drive.factor(), 1);
  drive.prescribe(0, true);
  EXPECT_EQ(drive.factor(), 4);
  EXPECT_EQ(drive.in_mean_flow(8), 2);
  drive.advance(0.5);
  drive.prescribe(0.5, true);
  EXPECT_EQ(drive.factor(), -2);
  drive.advance(0.5);
  EXPECT_EQ(drive.flow_time(77), 3);
  EXPECT_EQ(drive.carried(77), 1);
  EXPECT_EQ(FlowDrive(Scene{}).flow_time(77), 77);
  EXPECT_EQ(FlowDrive(Scene{}).carried(77), 77);
}

}  // namespace
}  // namespace clogflow::test
