// A flow file that fits by its words must fit by its numbers.
#include <gmock/gmock.h>

#include "coupling/flow/flow_flux.hpp"
#include "dem/run/model.hpp"
#include "tests/coupling/refusal.hpp"
#include "tests/dem/channel_scene.hpp"
#include "tests/dem/fluid/synthetic_flow.hpp"

namespace clogflow::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

template <class Change>
std::string refused(const Change& change) {
  const Scene scene = short_channel_scene();
  FlowGrid flow = synthetic_flow(scene);
  change(flow);
  return refusal([&] { make_model(scene, &flow, {}); });
}

std::string scaled(float factor) {
  return refused([&](FlowGrid& flow) {
    for (float& component : flow.velocity) component *= factor;
  });
}

// 5 mm/s times 400 um times 100 um: the rate of the scene.
TEST(FlowFits, WhatCarriesTheRateFromTheNarrowingToTheOutlet) {
  const Scene scene = short_channel_scene();
  const FlowGrid flow = synthetic_flow(scene);
  check_flow_fits(flow, scene);
  const auto planes = grid_fluxes(flow, scene, flow.origin.x);
  EXPECT_GT(planes.size(), 5u);
  for (const PlaneFlux& plane : planes) {
    EXPECT_NEAR(plane.flux, 2e-10, 0.02 * 2e-10);
    EXPECT_NEAR(plane.error, plane.flux / 2e-10 - 1, 1e-12);
  }
}

TEST(FlowFits, NotWhatCarriesNothing) {
  EXPECT_THAT(scaled(0), AllOf(HasSubstr("carries 0 m3/s through x = "), HasSubstr("-100 % off"),
                               HasSubstr("make it anew with clog case and clog map")));
}

TEST(FlowFits, NotWhatRunsBackwards) {
  EXPECT_THAT(scaled(-1), AllOf(HasSubstr("carries -"), HasSubstr("flow rate of the scene")));
}

TEST(FlowFits, NotAnotherRate) {
  const Scene scene = short_channel_scene();
  FlowGrid nearly = synthetic_flow(scene);
  for (float& component : nearly.velocity) component *= 1.05f;
  check_flow_fits(nearly, scene);
  EXPECT_THAT(scaled(1.2f), HasSubstr("off the flow rate of the scene (allowed 10 %)"));
}

TEST(FlowFits, NotWhatLiesElsewhere) {
  const char axis[] = {'x', 'y', 'z'};
  for (int a = 0; a < 3; ++a)
    EXPECT_THAT(refused([&](FlowGrid& flow) { flow.origin[a] += 4 * flow.spacing; }),
                HasSubstr(fmt::format("the grid of the flow file lies elsewhere: {} from ", axis[a])));
  EXPECT_THAT(refused([](FlowGrid& flow) { flow.spacing *= 2; }), HasSubstr("lies elsewhere"));
}

TEST(FlowFits, OnlyWhereAFlowIsAskedFor) {
  Scene scene = short_channel_scene();
  const FlowGrid flow = synthetic_flow(scene);
  scene.flow.source = FlowSource::uniform;
  EXPECT_THAT(refusal([&] { make_model(scene, &flow, {}); }),
              HasSubstr("flow.source is not \"openfoam\", so a flow file is of no use: leave it out"));
}

}  // namespace
}  // namespace clogflow::test
