// A toy of the stability map's second family: one term each, the prediction safe and tight.
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "trade/stability_terms.hpp"
#include "trade/term_columns.hpp"

namespace clogflow {
namespace {

Term term(int k) { return static_cast<Term>(k); }

TEST(StabilityTerms, EveryTermReachesFarOnItsAxis) {
  double largest_ratio = 1, least_density = 1, stickiest = 0, back = 0;
  std::set<std::string> names;
  for (int k = 1; k <= 200; ++k) {
    largest_ratio = std::max(largest_ratio, term_point(Term::sizes, k).size_ratio);
    least_density = std::min(least_density, term_point(Term::densities, k).density_ratio);
    stickiest = std::max(stickiest, term_point(Term::jkr, k).stickiness);
    back = std::max(back, term_point(Term::drive, k).amplitude);
  }
  for (int t = 0; t < term_count; ++t) names.insert(name(term(t)));
  EXPECT_GT(largest_ratio, 9.5);
  EXPECT_LT(least_density, 0.11);
  EXPECT_GT(stickiest, 80);
  EXPECT_GT(back, 1.9);
  EXPECT_EQ(names.size(), static_cast<std::size_t>(term_count));
}

TEST(StabilityTerms, APointHasItsTermAndNoOther) {
  for (int t = 0; t < term_count; ++t) {
    if (term(t) == Term::together) continue;
    const TermPoint p = term_point(term(t), 5);
    EXPECT_EQ(p.size_ratio != 1, term(t) == Term::sizes);
    EXPECT_EQ(p.density_ratio != 1, term(t) == Term::densities);
    EXPECT_EQ(p.friction_share != 1, term(t) == Term::frictions);
    EXPECT_EQ(p.stickiness > 0, term(t) == Term::jkr || term(t) == Term::dmt);
    EXPECT_EQ(p.weight > 0, term(t) == Term::gravity);
    EXPECT_EQ(p.amplitude > 0, term(t) == Term::drive);
    EXPECT_EQ(term_scene(p).geometry.present, in_channel(term(t)));
  }
}

TEST(StabilityTerms, SpheresByTurnsTouchAlongTheirStacks) {
  TermPoint p = term_point(Term::sizes, 1);
  p.base.particles = 18;
  const auto spheres = term_particles(p, 0.01);
  const double d = p.base.diameter, smallest = d / p.size_ratio;
  ASSERT_EQ(spheres.size(), 18u);
  EXPECT_DOUBLE_EQ(spheres[0].radius, d / 2);
  EXPECT_DOUBLE_EQ(spheres[1].radius, smallest / 2);
  EXPECT_DOUBLE_EQ(spheres[9].radius, smallest / 2);
  // One overlap of 0.01 of the smaller with the floor, one with the next.
  EXPECT_NEAR(spheres[0].z, d / 2 - 0.01 * smallest, 1e-12 * d);
  EXPECT_NEAR(spheres[9].z - spheres[0].z, (d + smallest) / 2 - 0.01 * smallest, 1e-12 * d);
}

TEST(StabilityTerms, APackShakesAboveThePredictedStepAndNotBelow) {
  int measured = 0;
  for (int t = 0; t < term_count; ++t) {
    const StepVerdict r = measure(term_point(term(t), 2));
    EXPECT_NE(r.verdict, Verdict::unstable) << name(term(t));
    EXPECT_TRUE(std::isfinite(r.predicted) && std::isfinite(r.measured)) << name(term(t));
    if (!r.at_rest) continue;
    ++measured;
    // Prediction and bisection are good to 1 % each.
    EXPECT_GE(r.measured, 0.98 * r.predicted) << name(term(t));
    EXPECT_LE(r.measured, 1.5 * r.predicted) << name(term(t));
  }
  EXPECT_GE(measured, 8);
}

}  // namespace
}  // namespace clogflow
