// What is known, and what is said where something is not.
#include <cmath>

#include <gmock/gmock.h>

#include "postprocess/laws/counting_interval.hpp"
#include "postprocess/laws/survival_test.hpp"
#include "postprocess/summary/quantities.hpp"
#include "tests/postprocess/laws/samples.hpp"

namespace clogflow::postprocess {
namespace {

using testing::HasSubstr;

Estimate known(const char* key, const std::vector<Totals>& seeds) {
  for (const Quantity& quantity : quantities())
    if (quantity.key == key) return estimate(quantity, {seeds, {.replicates = 200}});
  throw Error(key);
}

/// A seed with arrests of ten times T_min each, of which the end cut some.
Totals with_arrests(double arrests, double censored) {
  Totals totals;
  totals.seeds = totals.time = 1;
  totals.passages = totals.arrests = arrests;
  totals.censored = censored;
  totals.log_exposure = arrests * std::log(10.0);
  return totals;
}

TEST(Quantities, arrests_that_were_all_cut_have_no_exponent_but_a_bound) {
  const Estimate alpha = known("alpha_fixed", std::vector<Totals>(4, with_arrests(1, 1)));
  EXPECT_TRUE(std::isnan(alpha.value));
  EXPECT_TRUE(std::isnan(alpha.low));
  EXPECT_NEAR(alpha.high, 1 - std::log(0.05) / (4 * std::log(10.0)), 1e-12);
  EXPECT_EQ(alpha.note, "no arrest that a passage ended");
  EXPECT_EQ(known("alpha_fixed", {Totals{}, Totals{}}).note, "no arrest that a passage ended");
}

TEST(Quantities, seeds_that_agree_are_known_as_well_as_their_counts_only) {
  const Estimate alpha = known("alpha_fixed", std::vector<Totals>(4, with_arrests(3, 1)));
  const Estimate exact = rate_from_counts(8, 12 * std::log(10.0), 0.95);
  EXPECT_NEAR(alpha.low, 1 + exact.low, 1e-12);
  EXPECT_NEAR(alpha.high, 1 + exact.high, 1e-12);
  EXPECT_THAT(alpha.note, HasSubstr("interval of the counts"));
}

TEST(Quantities, bursts_of_one_particle_each_are_no_certainty) {
  Totals one;
  one.seeds = one.time = one.bursts = one.escaped = one.passages = 1;
  const Estimate mean = known("mean_burst", std::vector<Totals>(7, one));
  EXPECT_EQ(mean.value, 1);
  EXPECT_EQ(mean.low, 1);
  EXPECT_NEAR(1 / mean.high, 0.5904, 1e-4);  // 0.025^(1/7)
  EXPECT_NEAR(known("mean_burst_with_zeros", std::vector<Totals>(7, one)).high,
              mean_burst_from_counts(7, 14, 0.95).high - 1, 1e-12);
  EXPECT_NEAR(known("share_permanent", std::vector<Totals>(10, one)).high, 1 - std::pow(0.05, 0.1), 1e-12);
}

TEST(Quantities, what_has_no_counts_has_no_interval_then) {
  Totals half;
  half.seeds = half.time = 1;
  half.clogged_time = 0.5;
  const Estimate share = known("share_clogged", std::vector<Totals>(5, half));
  EXPECT_EQ(share.value, 0.5);
  EXPECT_TRUE(std::isnan(share.low));
  EXPECT_EQ(share.note, "resampled seeds all agree");
  EXPECT_EQ(known("share_clogged", {half}).note, "a single seed: no interval");
}

TEST(Quantities, a_change_that_all_seeds_share_is_no_proof_of_ageing) {
  Totals first, second;
  first.time = second.time = 1;
  first.passages = 2;
  second.passages = 1;
  for (const Quantity& quantity : quantities()) {
    if (quantity.key != "flow_rate") continue;
    const Estimate change = estimate_change(quantity, {{first, first}, {}}, {{second, second}, {}});
    EXPECT_EQ(change.value, -1);
    EXPECT_TRUE(std::isnan(change.low));
  }
}

// Clopper & Pearson 1934: 3 of 10, 95 %: 0.0667 to 0.6525.
TEST(CountingInterval, shares) {
  const Estimate share = share_from_counts(3, 10, 0.95);
  EXPECT_NEAR(share.low, 0.0667, 1e-4);
  EXPECT_NEAR(share.high, 0.6525, 1e-4);
  EXPECT_NEAR(share_from_counts(0, 10, 0.95).high, 0.2589, 1e-4);  // 1 - 0.05^(1/10)
  EXPECT_NEAR(share_from_counts(10, 10, 0.95).low, 0.7411, 1e-4);
  EXPECT_TRUE(std::isnan(share_from_counts(0, 0, 0.95).value));
  EXPECT_THAT(refusal([] { share_from_counts(2, 1, 0.95); }), HasSubstr("2 of 1"));
}

/// Arrests that the end of a run cuts at times between 2 and 12.
std::vector<Observation> censored_sample(const std::vector<double>& values, std::uint64_t seed) {
  RandomStream random(seed, 9);
  std::vector<Observation> sample;
  for (const double x : values) {
    const double end = 2 + 10 * random.uniform();
    sample.push_back({std::min(x, end), end < x});
  }
  return sample;
}

// 2 and 4 and one cut at 8, x_min = 1: alpha - 1 = 2/ln 64 = 0.4809, so the law is 0.7165 at 2 and
// 0.5134 at 4; S falls from 1 to 2/3 and to 1/3 there. Greenwood: 2/3 sqrt(1/6) = 0.2722, 1/3
// sqrt(1/6 + 1/2) = 0.2722.
TEST(SurvivalTest, by_hand) {
  const auto test = test_survival({{2, false}, {4, false}, {8, true}, {0.5, false}}, 1, 0, 1);
  EXPECT_NEAR(test.ks, 1 - std::pow(2, -2 / std::log(64.0)), 1e-12);
  EXPECT_EQ(test.at, 2);
  EXPECT_NEAR(test.standard_errors, (std::pow(4, -2 / std::log(64.0)) - 1.0 / 3) / 0.27217, 1e-4);
}

TEST(SurvivalTest, uniform_for_a_true_power_law) {
  int below_half = 0, below_tenth = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const auto sample = censored_sample(pareto_sample(80, 1.8, {seed, 3}), seed);
    const double p = test_survival(sample, 1, 100, seed).p_value;
    below_half += p < 0.5 ? 1 : 0;
    below_tenth += p < 0.1 ? 1 : 0;
  }
  EXPECT_NEAR(below_half, 50, 16);  // binomial, three standard deviations, and a little
  EXPECT_NEAR(below_tenth, 10, 10);
}

TEST(SurvivalTest, rules_out_what_is_exponential) {
  auto values = exponential_sample(300, 2, {4, 4});
  for (double& x : values) x += 1;
  const auto test = test_survival(censored_sample(values, 4), 1, 200, 1);
  EXPECT_LT(test.p_value, 0.01);
  EXPECT_GT(test.standard_errors, 3);
}

}  // namespace
}  // namespace clogflow::postprocess
