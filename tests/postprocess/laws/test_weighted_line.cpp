// Lines and counting intervals against published numbers and against coverage.
#include <cmath>
#include <random>

#include <gmock/gmock.h>

#include "postprocess/laws/counting_interval.hpp"
#include "postprocess/laws/weighted_line.hpp"
#include "tests/postprocess/laws/samples.hpp"

namespace clogflow::postprocess {
namespace {

using testing::HasSubstr;

/// The first of Anscombe's data sets with equal errors.
std::vector<LinePoint> anscombe(double sigma) {
  const std::vector<double> x{10, 8, 13, 9, 11, 14, 6, 4, 12, 7, 5};
  const std::vector<double> y{8.04, 6.95, 7.58, 8.81, 8.33, 9.96, 7.24, 4.26, 10.84, 4.82, 5.68};
  std::vector<LinePoint> points;
  for (std::size_t i = 0; i < x.size(); ++i) points.push_back({x[i], y[i], sigma});
  return points;
}

TEST(WeightedLine, without_errors_it_is_ordinary_least_squares) {
  // Anscombe 1973, Am. Stat. 27:17: slope 0.500 +- 0.118, intercept 3.00 +- 1.12, residual 1.237.
  const WeightedLine line = fit_line(anscombe(0), 0.95);
  EXPECT_NEAR(line.slope.value, 0.50009, 1e-5);
  EXPECT_NEAR(line.intercept.value, 3.00009, 1e-5);
  EXPECT_NEAR(line.extra_scatter, 1.2366, 1e-4);
  const double t9 = 2.262157;
  EXPECT_NEAR(line.slope.high - line.slope.value, t9 * 0.11791, 1e-4);
  EXPECT_NEAR(line.intercept.value - line.intercept.low, t9 * 1.12475, 1e-3);
}

TEST(WeightedLine, errors_that_explain_the_scatter_leave_none) {
  const WeightedLine line = fit_line(anscombe(2), 0.95);
  EXPECT_EQ(line.extra_scatter, 0);
  EXPECT_NEAR(line.chi_squared, 13.7627 / 4, 1e-4);  // residual sum of squares over sigma^2
  EXPECT_EQ(line.degrees_of_freedom, 9U);
  EXPECT_NEAR(line.p_value, 0.944, 1e-3);
  EXPECT_NEAR(line.slope.high - line.slope.value, 1.959964 * 2 / std::sqrt(110.0), 1e-6);
}

TEST(WeightedLine, the_better_known_points_decide) {
  const WeightedLine line = fit_line({{0, 0, 1e-3}, {1, 1, 1e-3}, {2, 2, 1e-3}, {3, 9, 10}}, 0.95);
  EXPECT_NEAR(line.slope.value, 1, 1e-4);
  EXPECT_EQ(line.extra_scatter, 0);
}

TEST(WeightedLine, intervals_cover_the_truth_with_and_without_extra_scatter) {
  for (const double extra : {0.0, 0.4}) {
    int covered = 0;
    constexpr int trials = 600;
    std::mt19937_64 engine(5);
    std::normal_distribution<double> normal;
    for (int k = 0; k < trials; ++k) {
      std::vector<LinePoint> points;
      for (int i = 0; i < 8; ++i) {
        const double sigma = 0.05 + 0.1 * (i % 3);
        points.push_back({1.0 * i, 1 + 0.3 * i + normal(engine) * std::hypot(sigma, extra), sigma});
      }
      const Estimate slope = fit_line(points, 0.95).slope;
      covered += slope.low <= 0.3 && 0.3 <= slope.high ? 1 : 0;
    }
    // Three binomial errors of 0.9 %; without extra scatter the interval is a little too wide,
    // because some is found by chance.
    EXPECT_GT(covered, 0.92 * trials) << extra;
    EXPECT_LT(covered, 0.995 * trials) << extra;
  }
}

TEST(WeightedLine, refusals) {
  EXPECT_THAT(refusal([] { fit_line({{0, 1, 1}, {1, 2, 1}}, 0.95); }), HasSubstr("2 points (a line needs 3)"));
  EXPECT_THAT(refusal([] {
                fit_line({{1, 1, 1}, {1, 2, 1}, {1, 3, 1}}, 0.95);
              }),
              HasSubstr("3 points at one place x = 1"));
}

TEST(CountingInterval, published_values) {
  // Garwood 1936: 10 events, 95 %: 4.795 to 18.39. Clopper & Pearson: 10 of 100: 0.0490 to 0.1762.
  const Estimate rate = rate_from_counts(10, 2.0, 0.95);
  EXPECT_NEAR(rate.value, 5, 1e-12);
  EXPECT_NEAR(rate.low, 4.795 / 2, 1e-3);
  EXPECT_NEAR(rate.high, 18.390 / 2, 1e-3);
  const Estimate mean = mean_burst_from_counts(10, 100, 0.95);
  EXPECT_NEAR(mean.value, 10, 1e-12);
  EXPECT_NEAR(1 / mean.high, 0.04900, 1e-5);
  EXPECT_NEAR(1 / mean.low, 0.17622, 1e-5);
}

TEST(CountingInterval, no_event_gives_a_bound) {
  const Estimate mean = mean_burst_from_counts(0, 300, 0.95);
  EXPECT_TRUE(std::isnan(mean.value));
  EXPECT_TRUE(std::isnan(mean.high));
  EXPECT_NEAR(std::pow(1 - 1 / mean.low, 300), 0.05, 1e-12);
  const Estimate rate = rate_from_counts(0, 4, 0.95);
  EXPECT_EQ(rate.low, 0);
  EXPECT_NEAR(rate.high, 2.9957 / 4, 1e-4);
  EXPECT_TRUE(std::isnan(mean_burst_from_counts(0, 0, 0.95).low));
  EXPECT_TRUE(std::isnan(rate_from_counts(0, 0, 0.95).high));
}

TEST(CountingInterval, every_burst_of_one_particle) {
  const Estimate mean = mean_burst_from_counts(7, 7, 0.95);
  EXPECT_EQ(mean.value, 1);
  EXPECT_EQ(mean.low, 1);
  EXPECT_NEAR(1 / mean.high, 0.5904, 1e-4);  // 0.025^(1/7)
  EXPECT_THAT(refusal([] { mean_burst_from_counts(2, 1, 0.95); }), HasSubstr("2 bursts with 1"));
}

TEST(CountingInterval, wider_of_two) {
  const Estimate both = wider({2, NAN, 5}, {3, 1, 4});
  EXPECT_EQ(both.value, 2);
  EXPECT_EQ(both.low, 1);
  EXPECT_EQ(both.high, 5);
}

}  // namespace
}  // namespace clogflow::postprocess
