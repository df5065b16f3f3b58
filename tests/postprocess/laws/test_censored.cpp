// Censored likelihoods, Kaplan-Meier and the rival law, by hand and against their limits.
#include <gmock/gmock.h>

#include "postprocess/laws/censored.hpp"
#include "postprocess/laws/power_law.hpp"
#include "postprocess/laws/rival.hpp"
#include "postprocess/laws/survival.hpp"
#include "tests/postprocess/laws/samples.hpp"

namespace clogflow::postprocess {
namespace {

using testing::HasSubstr;

// Two whole values 2 and 4, one censored at 8, one below x_min = 1: sum of ln = ln 64,
// alpha = 1 + 2/ln 64 = 1.480898..., sigma = 0.480898/sqrt 2.
TEST(Censored, power_law_by_hand) {
  const auto fit = fit_power_law_censored({{2, false}, {4, false}, {8, true}, {0.5, false}}, 1.0);
  EXPECT_NEAR(fit.parameter, 1.4808983469629878, 1e-14);
  EXPECT_NEAR(fit.sigma, 0.4808983469629878 / std::sqrt(2.0), 1e-14);
  EXPECT_EQ(fit.complete, 2U);
  EXPECT_EQ(fit.censored, 1U);
  EXPECT_EQ(censored_exponent(2, fit.exposure), fit.parameter);
}

// Two whole values 1 and 2 and one censored at 3 beyond x_min = 1: rate = 2/(0 + 1 + 2).
TEST(Censored, exponential_by_hand) {
  EXPECT_NEAR(fit_exponential_censored({{1, false}, {2, false}, {3, true}}, 1.0).parameter, 2.0 / 3.0, 1e-15);
}

TEST(Censored, without_censored_values_it_is_the_plain_fit) {
  const auto values = pareto_sample(200, 2.3, {1, 1});
  std::vector<Observation> observations;
  for (const double x : values) observations.push_back({x, false});
  EXPECT_NEAR(fit_power_law_censored(observations, 1.5).parameter, fit_power_law(SortedSample(values), 1.5).alpha,
              1e-12);
}

// alpha = 1.6 with everything beyond 10 cut: a quarter of the sample is censored.
TEST(Censored, recovers_the_exponent_that_dropping_or_keeping_would_miss) {
  std::vector<Observation> observations;
  std::vector<double> dropped;
  for (const double x : pareto_sample(20000, 1.6, {2, 2})) {
    observations.push_back({std::min(x, 10.0), x > 10.0});
    if (x <= 10.0) dropped.push_back(x);
  }
  const auto fit = fit_power_law_censored(observations, 1.0);
  EXPECT_NEAR(fit.parameter, 1.6, 3.0 * fit.sigma);
  EXPECT_GT(fit_power_law(SortedSample(dropped), 1.0).alpha, 1.9);
}

TEST(Censored, refusals) {
  EXPECT_THAT(refusal([] {
                fit_power_law_censored({{5, true}, {6, true}}, 1.0);
              }),
              HasSubstr("no whole value above xmin = 1 (2 censored ones)"));
  EXPECT_THAT(refusal([] { fit_exponential_censored({{5, false}}, 0.0); }), HasSubstr("xmin = 0 (must be positive)"));
}

// Textbook example (remission of leukaemia, 6-MP arm: Freireich et al. 1963; Kaplan-Meier values in
// Kleinbaum & Klein, Survival Analysis, table 2.2): S = 0.8571, 0.8067, 0.7529, 0.6902, 0.6275,
// 0.5378, 0.4482.
TEST(KaplanMeier, textbook_example) {
  std::vector<Observation> remissions;
  for (const double t : {6, 6, 6, 7, 10, 13, 16, 22, 23}) remissions.push_back({t, false});
  for (const double t : {6, 9, 10, 11, 17, 19, 20, 25, 32, 32, 34, 35}) remissions.push_back({t, true});
  const auto steps = kaplan_meier(remissions);
  const std::vector<double> time{6, 7, 10, 13, 16, 22, 23};
  const std::vector<double> survival{0.8571, 0.8067, 0.7529, 0.6902, 0.6275, 0.5378, 0.4482};
  const std::vector<std::size_t> at_risk{21, 17, 15, 12, 11, 7, 6};
  ASSERT_EQ(steps.size(), 7U);
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_EQ(steps[i].time, time[i]);
    EXPECT_EQ(steps[i].at_risk, at_risk[i]);
    EXPECT_NEAR(steps[i].survival, survival[i], 5e-5);
  }
  EXPECT_NEAR(steps[0].error, 0.0764, 5e-5);  // Greenwood, ibid.
}

TEST(KaplanMeier, without_censoring_it_is_the_empirical_survival) {
  const auto steps = kaplan_meier(std::vector<Observation>{{3, false}, {1, false}, {2, false}, {2, false}});
  ASSERT_EQ(steps.size(), 3U);
  EXPECT_DOUBLE_EQ(steps[0].survival, 0.75);
  EXPECT_DOUBLE_EQ(steps[1].survival, 0.25);
  EXPECT_DOUBLE_EQ(steps[2].survival, 0.0);
  EXPECT_DOUBLE_EQ(steps[2].error, 0.0);
  EXPECT_TRUE(kaplan_meier(std::vector<Observation>{}).empty());
}

std::vector<Observation> whole(const std::vector<double>& values) {
  std::vector<Observation> observations;
  for (const double x : values) observations.push_back({x, false});
  return observations;
}

TEST(Rival, tells_the_laws_apart) {
  const auto power = power_law_against_exponential(whole(pareto_sample(1000, 2.0, {1, 3})), 1.0);
  EXPECT_GT(power.log_ratio, 0);
  EXPECT_LT(power.p_value, 0.01);
  auto values = exponential_sample(1000, 1.0, {1, 4});
  for (double& x : values) x += 1.0;
  const auto exponential = power_law_against_exponential(whole(values), 1.0);
  EXPECT_LT(exponential.log_ratio, 0);
  EXPECT_LT(exponential.p_value, 0.01);
  EXPECT_NEAR(exponential.rate, 1.0, 0.1);
}

// Values 2 and 4 from x_min = 1: a = alpha - 1 = 2/ln 8, rate = 2/4.
// R = sum [ln a - (a + 1) ln x] - sum [ln(1/2) - (x - 1)/2] = 2 ln a - (a + 1) ln 8 + 2 ln 2 + 2.
TEST(Rival, ratio_by_hand) {
  const double a = 2.0 / std::log(8.0);
  const auto test = power_law_against_exponential(whole({2, 4}), 1.0);
  EXPECT_NEAR(test.log_ratio, 2 * std::log(a) - (a + 1) * std::log(8.0) + 2 * std::log(2.0) + 2, 1e-13);
}

}  // namespace
}  // namespace clogflow::postprocess
