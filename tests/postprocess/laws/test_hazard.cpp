// Counts of trials until an event, some of them cut: hazard, survival and mean, by hand and against a known law.
#include <cmath>

#include <gmock/gmock.h>

#include "postprocess/laws/hazard.hpp"
#include "postprocess/laws/restricted_mean.hpp"
#include "postprocess/laws/survival.hpp"
#include "tests/postprocess/laws/samples.hpp"

namespace clogflow::postprocess {
namespace {

constexpr double level = 0.95;

// Outcomes seen in trial 0: five, one an event; in trial 1: four; in trial 2: three, one an event (who was cut after
// two trials is not among them); in trial 3: two, one an event; in trial 4: one.
const std::vector<TrialCount> five{{0, true}, {2, true}, {2, false}, {3, true}, {5, false}};

TEST(TrialCount, sums) {
  const TrialSums sums = sums_of(five);
  EXPECT_EQ(sums.events, 3U);
  EXPECT_EQ(sums.passed, 12U);
  EXPECT_EQ(sums.largest, 5U);
  EXPECT_EQ(trials_of(five[1]), 3U);
  EXPECT_EQ(trials_of(five[2]), 2U);
}

// S = 4/5, 4/5 2/3, 4/5 2/3 1/2; Greenwood: S sqrt(1/(5 4) + 1/(3 2) + 1/(2 1)) at the last.
TEST(TrialCount, survival_by_hand) {
  const auto steps = kaplan_meier(as_observations(five));
  ASSERT_EQ(steps.size(), 3U);
  EXPECT_EQ(steps[1].time, 2);
  EXPECT_EQ(steps[1].at_risk, 3U);
  EXPECT_NEAR(steps[0].survival, 0.8, 1e-14);
  EXPECT_NEAR(steps[1].survival, 8.0 / 15, 1e-14);
  EXPECT_NEAR(steps[2].survival, 4.0 / 15, 1e-14);
  EXPECT_NEAR(steps[2].error, 4.0 / 15 * std::sqrt(1.0 / 20 + 1.0 / 6 + 1.0 / 2), 1e-14);
}

// 3 events in 15 trials; Clopper & Pearson: 0.0433 to 0.4809.
TEST(Hazard, by_hand) {
  const Estimate hazard = hazard_per_trial(five, level);
  EXPECT_DOUBLE_EQ(hazard.value, 0.2);
  EXPECT_NEAR(hazard.low, 0.0433, 1e-4);
  EXPECT_NEAR(hazard.high, 0.4809, 1e-4);
  const Estimate mean = mean_of_hazard(hazard);
  EXPECT_DOUBLE_EQ(mean.value, 4);
  EXPECT_DOUBLE_EQ(mean.low, 1 / hazard.high - 1);
  EXPECT_DOUBLE_EQ(mean.high, 1 / hazard.low - 1);
}

// 1 - 0.05^(1/300) = 0.009936, by the rule of three about 3/300.
TEST(Hazard, without_an_event_only_its_upper_bound_is_known) {
  const std::vector<TrialCount> none{{100, false}, {200, false}};
  const Estimate hazard = hazard_per_trial(none, level);
  EXPECT_EQ(hazard.value, 0);
  EXPECT_EQ(hazard.low, 0);
  EXPECT_NEAR(hazard.high, 0.009936, 1e-6);
  const auto bins = hazard_bins(none, 10, level);
  ASSERT_EQ(bins.size(), 1U);
  EXPECT_EQ(bins[0].to, 200U);
  EXPECT_EQ(bins[0].trials, 300U);
  EXPECT_EQ(bins[0].hazard.high, hazard.high);
  const MeanCount mean = mean_count(none, {});
  EXPECT_TRUE(std::isnan(mean.mean.value) && std::isnan(mean.mean.high));
  EXPECT_NEAR(mean.mean.low, 1 / hazard.high - 1, 1e-12);
  EXPECT_EQ(mean.mean.note, "no event: bound of a law without memory");
}

TEST(Hazard, nothing_seen) {
  EXPECT_TRUE(std::isnan(hazard_per_trial({{0, false}}, level).value));
  EXPECT_TRUE(hazard_bins({{0, false}}, 10, level).empty());
  EXPECT_TRUE(hazard_bins({}, 10, level).empty());
}

TEST(Hazard, bins_by_hand) {
  const auto bins = hazard_bins(five, 1, level);
  ASSERT_EQ(bins.size(), 3U);
  const std::size_t from[] = {0, 1, 3}, to[] = {1, 3, 5}, trials[] = {5, 7, 3};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(bins[k].from, from[k]);
    EXPECT_EQ(bins[k].to, to[k]);
    EXPECT_EQ(bins[k].trials, trials[k]);
    EXPECT_EQ(bins[k].events, 1U);
    EXPECT_DOUBLE_EQ(bins[k].hazard.value, 1.0 / static_cast<double>(trials[k]));
  }
  // Two events an bin leave one over, which belongs to the only one.
  ASSERT_EQ(hazard_bins(five, 2, level).size(), 1U);
  EXPECT_EQ(hazard_bins(five, 2, level)[0].trials, 15U);
  // Events of one trial stay together.
  EXPECT_EQ(hazard_bins({{0, true}, {0, true}, {0, true}, {1, true}}, 1, level)[0].events, 3U);
}

TEST(RestrictedMean, by_hand) {
  // S(0) + ... + S(4) = 4/5 + 4/5 + 8/15 + 4/15 + 4/15.
  EXPECT_NEAR(restricted_mean(five, 5), 8.0 / 3, 1e-14);
  EXPECT_NEAR(restricted_mean(five, 2), 1.6, 1e-14);
  const MeanCount mean = mean_count(five, {.replicates = 400});
  EXPECT_NEAR(mean.mean.value, 8.0 / 3, 1e-14);
  EXPECT_TRUE(mean.is_restricted);
  EXPECT_EQ(mean.up_to, 5U);
  EXPECT_LT(mean.mean.low, 8.0 / 3);
  EXPECT_GT(mean.mean.high, 8.0 / 3);
}

TEST(RestrictedMean, without_a_cut_count_it_is_the_plain_mean) {
  const MeanCount mean = mean_count({{0, true}, {1, true}, {1, true}, {7, true}}, {.replicates = 200});
  EXPECT_DOUBLE_EQ(mean.mean.value, 9.0 / 4);
  EXPECT_FALSE(mean.is_restricted);
}

TEST(RestrictedMean, counts_that_agree_are_known_as_well_as_the_law_says) {
  const MeanCount mean = mean_count(std::vector<TrialCount>(6, {4, true}), {.replicates = 50});
  const Estimate exact = mean_of_hazard(hazard_per_trial(std::vector<TrialCount>(6, {4, true}), level));
  EXPECT_EQ(mean.mean.value, 4);
  EXPECT_EQ(mean.mean.low, exact.low);
  EXPECT_EQ(mean.mean.high, exact.high);
  EXPECT_EQ(mean.mean.note, "resampled seeds all agree; interval of the counts");
  EXPECT_EQ(mean_count({{4, true}}, {}).mean.note, "a single seed: no interval");
  // Clogged at once, every time: the mean is 0 and its upper end 1/0.025^(1/6) - 1.
  const Estimate zero = mean_count(std::vector<TrialCount>(6, {0, true}), {.replicates = 50}).mean;
  EXPECT_EQ(zero.value, 0);
  EXPECT_NEAR(zero.high, std::pow(0.05, -1.0 / 6) - 1, 1e-12);
}

/// Geometric counts; with a longest, each is cut after a number of trials that is uniform up to it.
std::vector<TrialCount> geometric_counts(std::size_t n, double hazard, double longest, RandomStream random) {
  std::vector<TrialCount> sample;
  for (std::size_t i = 0; i < n; ++i) {
    const auto whole = static_cast<std::size_t>(std::log1p(-random.uniform()) / std::log1p(-hazard));
    const auto end = longest > 0 ? static_cast<std::size_t>(longest * random.uniform()) : whole + 1;
    sample.push_back(whole < end ? TrialCount{whole, true} : TrialCount{end, false});
  }
  return sample;
}

struct Coverage {
  double hazard = 0, mean = 0;
};

/// How often intervals hold the truth: the hazard, and the mean restricted to `up_to`.
Coverage coverage(double hazard, double longest) {
  Coverage covered;
  constexpr std::uint64_t ensembles = 600;
  for (std::uint64_t k = 0; k < ensembles; ++k) {
    const auto sample = geometric_counts(40, hazard, longest, {k, 31});
    const Estimate h = hazard_per_trial(sample, level);
    const MeanCount mean = mean_count(sample, {.replicates = 200, .seed = k});
    // sum_{n < L} (1 - h)^(n + 1) = (1 - h)/h (1 - (1 - h)^L); the whole mean where the sample holds it.
    const double go_on = 1 - hazard, all = go_on / hazard;
    const double truth = mean.is_restricted ? all * (1 - std::pow(go_on, static_cast<double>(mean.up_to))) : all;
    covered.hazard += h.low <= hazard && hazard <= h.high ? 1.0 / ensembles : 0.0;
    covered.mean += mean.mean.low <= truth && truth <= mean.mean.high ? 1.0 / ensembles : 0.0;
  }
  return covered;
}

// The exact interval covers 95 % or a little more; the percentile interval of 40 skewed values a little less.
// Binomial error of 600 ensembles: 0.9 %.
TEST(Hazard, intervals_hold_a_known_hazard_and_its_mean) {
  for (const double longest : {0.0, 40.0}) {
    const Coverage covered = coverage(0.1, longest);
    EXPECT_GT(covered.hazard, 0.93) << longest;
    EXPECT_LT(covered.hazard, 0.985) << longest;
    EXPECT_GT(covered.mean, 0.88) << longest;
    EXPECT_LT(covered.mean, 0.98) << longest;
  }
}

}  // namespace
}  // namespace clogflow::postprocess
