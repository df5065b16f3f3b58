// When an ensemble says enough.
#include <cmath>

#include <gmock/gmock.h>

#include "coupling/base/require.hpp"
#include "postprocess/laws/counting_interval.hpp"
#include "postprocess/summary/stopping_rule.hpp"

namespace clogflow::postprocess {
namespace {

using testing::HasSubstr;

/// A seed with so many bursts of so many particles in all.
Totals seed(double bursts, double escaped) {
  Totals totals;
  totals.seeds = totals.time = 1;
  totals.bursts = bursts;
  totals.escaped = totals.passages = escaped;
  return totals;
}

std::string refusal(const std::string& rule) {
  try {
    StoppingRule{rule};
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(StoppingRule, CountsAddUpOverSeeds) {
  const StoppingRule rule("bursts>=10");
  EXPECT_FALSE(rule.met({}));
  EXPECT_FALSE(rule.met({seed(4, 40), seed(5, 50)}));
  EXPECT_TRUE(rule.met({seed(4, 40), seed(6, 50)}));
  EXPECT_EQ(rule.value({seed(4, 40), seed(5, 50)}), 9);
  EXPECT_TRUE(StoppingRule(" passages >= 90 ").met({seed(4, 40), seed(5, 50)}));
}

// Seeds that are all alike have no spread, and yet 100 bursts are known no better than their number says.
TEST(StoppingRule, ARelativeErrorIsNeverLessThanThatOfTheCounts) {
  const std::vector<Totals> alike(5, seed(20, 200));
  const Estimate exact = mean_burst_from_counts(100, 1000, 0.95);
  const StoppingRule rule("relative_error(mean_burst)<=0.2");
  EXPECT_NEAR(rule.value(alike), (exact.high - exact.low) / 2 / 10, 1e-12);
  EXPECT_NEAR(rule.value(alike), 1.96 * std::sqrt(0.9 / 100), 0.01);  // of a geometric law, to first order
  EXPECT_TRUE(rule.met(alike));
  EXPECT_FALSE(StoppingRule("relative_error(mean_burst)<=0.15").met(alike));
}

TEST(StoppingRule, ARelativeErrorKnowsTheSpreadOfTheSeeds) {
  std::vector<Totals> seeds;
  for (int k = 0; k < 40; ++k) seeds.push_back(seed(100, k % 2 ? 500 : 1500));
  // Means of 5 and 15: the mean of 40 seeds has the standard error 5/sqrt(40).
  EXPECT_NEAR(StoppingRule("relative_error(mean_burst)<=0.1").value(seeds), 1.96 * 5 / std::sqrt(40) / 10, 0.015);
}

TEST(StoppingRule, FewSeedsOrNoBurstsMeetNoRelativeError) {
  const StoppingRule rule("relative_error(mean_burst)<=10");
  EXPECT_FALSE(rule.met(std::vector<Totals>(StoppingRule::fewest_seeds - 1, seed(20, 200))));
  EXPECT_TRUE(rule.met(std::vector<Totals>(StoppingRule::fewest_seeds, seed(20, 200))));
  EXPECT_FALSE(rule.met(std::vector<Totals>(20, seed(0, 0))));
}

TEST(StoppingRule, SaysWhatIsWrong) {
  EXPECT_EQ(refusal("enough"), "--until enough (must be like 'bursts>=1000' or 'relative_error(mean_burst)<=0.05')");
  EXPECT_THAT(refusal("clogs>=3"), HasSubstr("must bound bursts, arrests, passages, releases or relative_error(...)"));
  EXPECT_THAT(refusal("bursts<=3"), HasSubstr("a number of events is bounded with >="));
  EXPECT_THAT(refusal("bursts>=many"), HasSubstr("its bound must be a positive number"));
  EXPECT_THAT(refusal("bursts>=-1"), HasSubstr("its bound must be a positive number"));
  EXPECT_THAT(refusal("relative_error(mean_burst)>=0.1"), HasSubstr("a relative error is bounded with <="));
  EXPECT_THAT(refusal("relative_error(size)<=0.1"), HasSubstr("is that of one of: mean_burst, "));
  EXPECT_THAT(refusal("bursts(mean_burst)>=0.1"), HasSubstr("must bound bursts"));
}

}  // namespace
}  // namespace clogflow::postprocess
