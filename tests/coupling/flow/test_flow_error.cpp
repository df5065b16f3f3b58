#include "coupling/flow/flow_error.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "tests/coupling/flow_scene.hpp"
#include "tests/coupling/refusal.hpp"

namespace clogflow {
namespace {

FoamSamples samples(float error) {
  FoamSamples result;
  result.points = {200, 1, 1};
  for (int i = 0; i < 200; ++i) {
    result.velocity.push_back({1 + (i == 7 ? 10 : 1) * error, 0, 0});
    result.found.push_back(i != 3);
  }
  return result;
}

// Errors e and 2^1.5 e of a quantity of order 1.5: the estimate is e itself.
TEST(RichardsonError, IsExactForItsOrder) {
  const double growth = std::pow(2, 1.5);
  EXPECT_NEAR(richardson_error(1 + 1e-3, 1 + growth * 1e-3), 1e-3, 1e-5);
  const float e = 1e-3f;
  const VelocityError found = richardson_error(samples(e), samples(static_cast<float>(growth) * e), 2);
  EXPECT_NEAR(found.most, 0.5e-3, 1e-6);
  // One of 199 points is off ten times as much.
  EXPECT_NEAR(found.rms, 0.5e-3 * std::sqrt((198 + 100) / 199.0), 1e-6);
  // There the order is 1/2: (2^1.5 - 1) / (2^0.5 - 1) times as much again.
  EXPECT_NEAR(found.largest, 5e-3 * (growth - 1) / (std::sqrt(2) - 1), 1e-5);
}

// Errors e and 2^1.8 e of a quantity of order 1.8: nothing of it is left, and 5/4 of e is told.
TEST(Extrapolation, IsExactForItsOrder) {
  const double growth = std::pow(2, 1.8);
  EXPECT_NEAR(1 + 1e-3 + correction(1 + 1e-3, 1 + growth * 1e-3), 1, 1e-12);
  const float e = 1e-3f;
  FoamSamples fine = samples(e);
  const VelocityError told = extrapolate(fine, samples(static_cast<float>(growth) * e), 2);
  EXPECT_NEAR(fine.velocity[0][0], 1, 1e-6);
  EXPECT_NEAR(fine.velocity[7][0], 1, 1e-6);
  EXPECT_EQ(fine.velocity[3][0], 1 + e) << "a point that the meshes do not share";
  EXPECT_NEAR(told.most, 1.25 * 0.5e-3, 1e-6);
  EXPECT_NEAR(told.largest, 1.25 * 5e-3, 1e-6);
}

// Where the coarser mesh is off by more than the flow is fast, the difference is no correction.
TEST(Extrapolation, LeavesWhatTheCoarserMeshDoesNotResolve) {
  FoamSamples fine = samples(0), coarse = samples(0);
  coarse.velocity[7] = {-2, 0, 0};
  coarse.velocity[8] = {0, 0, 1};
  const VelocityError told = extrapolate(fine, coarse, 1);
  EXPECT_EQ(fine.velocity[7][0], 1);
  EXPECT_EQ(fine.velocity[8][2], 0);
  EXPECT_NEAR(told.largest, 1.25 * 3 / (std::pow(2, 1.8) - 1), 1e-6) << "is told all the same";
}

TEST(RichardsonError, RefusesSamplesThatDoNotFit) {
  FoamSamples other = samples(0);
  other.points = {100, 2, 1};
  EXPECT_THAT(refusal([&] { richardson_error(samples(0), other, 1); }), testing::HasSubstr("at other points"));
  other = samples(0);
  other.found.assign(200, 0);
  EXPECT_THAT(refusal([&] { richardson_error(samples(0), other, 1); }), testing::HasSubstr("no point in common"));
}

// Of any shape, where the mesh is fine enough for its error to be a power of the cells' size.
TEST(FlowExtrapolation, IsTheDefaultFromSixteenCellsOn) {
  for (const auto& [cells, wanted] : {std::pair("16", true), {"15", false}}) {
    const Overrides override{std::string("flow.mesh_cells_per_neck=") + cells};
    EXPECT_EQ(flow_scene(override).flow.extrapolate, wanted) << cells;
    EXPECT_EQ(read_scene(source_folder() / "scenes" / "pore.toml", override).flow.extrapolate, wanted) << cells;
  }
}

}  // namespace
}  // namespace clogflow
