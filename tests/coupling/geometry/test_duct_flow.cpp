#include "coupling/geometry/duct_flow.hpp"

#include <gmock/gmock.h>

#include "coupling/base/require.hpp"
#include "tests/coupling/refusal.hpp"

namespace clogflow {
namespace {

// Shah & London, Laminar Flow Forced Convection in Ducts, table 42: largest over mean velocity.
TEST(DuctFlow, LargestVelocityIsThePublishedOne) {
  EXPECT_NEAR(DuctFlow(1, 1)(0, 0.5), 2.0962, 1e-4);
  EXPECT_NEAR(DuctFlow(2, 1)(0, 0.5), 1.9918, 2e-4);
  EXPECT_NEAR(DuctFlow(4, 1)(0, 0.5), 1.7737, 2e-4);
}

TEST(DuctFlow, InAPipeIsThatOfPoiseuille) {
  Geometry pipe;
  pipe.channel_width = pipe.neck_height = 2e-4, pipe.inlet_area = M_PI * 1e-8;  // R = 100 um
  const DuctFlow flow = DuctFlow::of_channel(pipe);
  EXPECT_NEAR(flow(0, 1e-4), 2, 1e-12);
  EXPECT_NEAR(flow(30e-6, 1e-4 - 40e-6), 1.5, 1e-12);
  EXPECT_EQ(flow(80e-6, 170e-6), 0);
  EXPECT_NEAR(flow.resistance(), 8e8, 1);
  pipe.inlet_area = 0;
  EXPECT_NEAR(DuctFlow::of_channel(pipe)(0, 1e-4), 2.0962, 1e-4);
}

TEST(DuctFlow, BecomesTheParabolaBetweenPlates) {
  const DuctFlow duct(1000, 1);
  EXPECT_NEAR(duct(0, 0.5), 1.5, 1.5e-3);  // the side walls slow 0.63 / 1000 of the width
  EXPECT_NEAR(duct(0, 0.25) / duct(0, 0.5), 0.75, 1e-5);
}

TEST(DuctFlow, DoesNotDependOnWhichSideIsCalledWidth) {
  const DuctFlow flat(3, 1), tall(1, 3);
  EXPECT_NEAR(flat(0.7, 0.2), tall(0.2 - 0.5, 0.7 + 1.5), 1e-12);
  const double a = flat.mean_over({.y_min = 0.1, .y_max = 0.7, .z_min = 0.2, .z_max = 0.3});
  const double b = tall.mean_over({.y_min = -0.3, .y_max = -0.2, .z_min = 1.6, .z_max = 2.2});
  EXPECT_NEAR(a, b, 1e-12);
}

TEST(DuctFlow, IsZeroOnAndBehindTheWalls) {
  const DuctFlow duct(4e-4, 1e-4);
  EXPECT_EQ(duct(2e-4, 5e-5), 0);
  EXPECT_EQ(duct(0, 0), 0);
  EXPECT_EQ(duct(0, 1e-4), 0);
  EXPECT_EQ(duct(-3e-4, 5e-5), 0);
}

TEST(DuctFlow, MeansOverTilesAddUpToTheMean) {
  const DuctFlow duct(4, 1);
  EXPECT_NEAR(duct.mean_over({.y_min = -2, .y_max = 2, .z_min = 0, .z_max = 1}), 1, 1e-7);
  double sum = 0;
  for (int i = 0; i < 8; ++i) {
    sum += duct.mean_over({.y_min = -2 + 0.5 * i, .y_max = -1.5 + 0.5 * i, .z_min = 0, .z_max = 1}) / 8;
  }
  EXPECT_NEAR(sum, 1, 1e-7);
}

TEST(DuctFlow, MeanOverASmallRectangleIsTheVelocityThere) {
  const DuctFlow duct(4, 1);
  const double mean = duct.mean_over({.y_min = 1.2, .y_max = 1.201, .z_min = 0.3, .z_max = 0.301});
  EXPECT_NEAR(mean, duct(1.2005, 0.3005), 1e-6);
}

TEST(DuctFlow, RefusesADuctWithoutASide) {
  EXPECT_THAT(refusal([] { DuctFlow(0, 1); }), testing::HasSubstr("both sides must be positive"));
}

// F. M. White, Viscous Fluid Flow: f Re = 56.91 for a square, 96 for two plates, with the hydraulic diameter D:
// dp/dx = f Re mu U / (2 D^2).
TEST(DuctFlow, ResistanceOfASquareAndOfTwoPlates) {
  EXPECT_NEAR(DuctFlow(1, 1).resistance(), 56.91 / 2, 0.003);
  EXPECT_NEAR(DuctFlow(1e5, 1).resistance(), 12, 1e-3);
  EXPECT_DOUBLE_EQ(DuctFlow(4, 1).resistance(), DuctFlow(1, 4).resistance());
}

}  // namespace
}  // namespace clogflow
