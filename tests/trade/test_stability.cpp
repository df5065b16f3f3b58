// A toy of the stability map: the prediction is safe, every point ends in a verdict.
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "trade/stability.hpp"

namespace clogflow {
namespace {

TEST(StabilityMap, PointsReachFarOnEveryAxis) {
  double least = 1, largest = 0;
  std::set<int> numbers;
  for (int k = 1; k <= 300; ++k) {
    const ExtremePoint p = extreme_point(k);
    numbers.insert(p.number);
    least = std::min(least, p.diameter), largest = std::max(largest, p.diameter);
    EXPECT_GE(p.porosity, 0.36);
    EXPECT_LE(p.restitution, 1);
    EXPECT_GE(p.particles, 1);
  }
  EXPECT_EQ(numbers.size(), 300u);
  EXPECT_LT(least, 1.1e-6);
  EXPECT_GT(largest, 0.9e-3);
}

TEST(StabilityMap, APackAtRestShakesAboveThePredictedStepAndNotBelow) {
  int measured = 0;
  for (int k = 1; k <= 16; ++k) {
    const StepVerdict r = measure(extreme_point(k));
    EXPECT_NE(r.verdict, Verdict::unstable) << k;
    EXPECT_TRUE(std::isfinite(r.predicted) && std::isfinite(r.measured)) << k;
    if (!r.at_rest) continue;
    ++measured;
    // Prediction and bisection are good to 1 % each.
    EXPECT_GE(r.measured, 0.98 * r.predicted) << k;
    EXPECT_LE(r.measured, 1.5 * r.predicted) << k;
  }
  EXPECT_GE(measured, 7);
}

}  // namespace
}  // namespace clogflow
