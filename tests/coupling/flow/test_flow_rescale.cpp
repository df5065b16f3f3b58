#include "coupling/flow/flow_rescale.hpp"

#include <gmock/gmock.h>

#include "tests/coupling/flow_scene.hpp"
#include "tests/coupling/refusal.hpp"

namespace clogflow {
namespace {

using testing::HasSubstr;

FlowGrid solved(const Overrides& overrides) {
  const Scene scene = flow_scene(overrides);
  FlowGrid grid;
  grid.velocity = {2e-3f, -1e-3f, 0};
  grid.scene_text = effective_scene(scene);
  grid.hash = content_hash(flow_inputs(scene));
  return grid;
}

// 1062 kg/m3 * 20 mm/s * 100 um / 1.8 mPa s = 1.18
TEST(FlowRescale, ReynoldsNumberOfTheNeck) { EXPECT_NEAR(neck_reynolds_number(flow_scene()), 1.18, 1e-6); }

TEST(FlowRescale, ScalesAndTellsTheError) {
  const Scene scene = flow_scene({"flow.rescale=true"});
  const RescaledFlow flow = rescaled_flow(solved({"flow.mean_velocity=10 um/s"}), scene);
  EXPECT_DOUBLE_EQ(flow.factor, 500);
  EXPECT_FLOAT_EQ(flow.grid.velocity[0], 1);
  EXPECT_FLOAT_EQ(flow.grid.velocity[1], -0.5);
  // The reference solutions of the 60 degree shape, Stokes and Navier-Stokes at 5 mm/s, differ by 3.3 %
  // of the neck's mean: the stated error must cover that, and not by much.
  EXPECT_GT(flow.error, 0.033);
  EXPECT_LT(flow.error, 0.036);
  check_flow_belongs(scene, flow.grid);
  EXPECT_DOUBLE_EQ(rescaled_flow(solved({}), scene).error, 0);
}

TEST(FlowRescale, ScalesThePressureDrop) {
  FlowGrid slow = solved({"flow.mean_velocity=10 um/s"});
  slow.record.pressure_drop = 0.04;
  const Scene scene = flow_scene({"flow.rescale=true", "fluid.viscosity=3.6e-3 Pa s"});
  EXPECT_DOUBLE_EQ(*rescaled_flow(slow, scene).grid.record.pressure_drop, 0.04 * 500 * 2);
}

TEST(FlowRescale, NeedsTheSameChannelAndSlowFlow) {
  const auto refused = [](const Overrides& file, const Overrides& scene) {
    return refusal([&] { rescaled_flow(solved(file), flow_scene(scene)); });
  };
  EXPECT_THAT(refused({"geometry.half_angle=45 deg"}, {}), AllOf(HasSubstr("another scene"), HasSubstr("half_angle")));
  EXPECT_THAT(refused({"geometry.neck_rounding=10 um"}, {}), HasSubstr("neck_rounding"));
  EXPECT_THAT(refused({}, {"flow.mean_velocity=10 mm/s"}),
              HasSubstr("Reynolds number is 2.36, and the error of scaling is known up to 1.2"));
}

// 1.25 widths of 400 um are solved: beyond 500 um every length is served, below it none but its own.
TEST(FlowBelongs, EveryLengthBeyondWhatIsSolved) {
  const auto check = [](const char* file, const char* scene) {
    const std::string key = "geometry.channel_length=";
    check_flow_belongs(flow_scene({key + scene}), solved({key + file}));
  };
  EXPECT_NO_THROW(check("1 mm", "3 mm"));
  EXPECT_NO_THROW(check("500 um", "1 mm"));
  EXPECT_NO_THROW(check("1 mm", "500 um"));
  EXPECT_THAT(refusal([&] { check("1 mm", "480 um"); }), HasSubstr("channel_length"));
  EXPECT_THAT(refusal([&] { check("300 um", "1 mm"); }), HasSubstr("channel_length"));
}

TEST(FlowBelongs, WhateverItsNameIfItsInputsAgree) {
  FlowGrid flow = solved({});
  flow.hash = "of an older version";
  EXPECT_NO_THROW(check_flow_belongs(flow_scene(), flow));
}

TEST(FlowRescale, OtherwiseAllMustAgree) {
  EXPECT_THAT(refusal([] { check_flow_belongs(flow_scene({"flow.mean_velocity=1 mm/s"}), solved({})); }),
              AllOf(HasSubstr("mean_velocity = \"5 mm/s\""), HasSubstr("\"1 mm/s\"")));
}

}  // namespace
}  // namespace clogflow
