// The first bursts of an ensemble, and what is said where none clogged.
#include <cmath>

#include <gmock/gmock.h>

#include "postprocess/laws/counting_interval.hpp"
#include "postprocess/summary/group_statistics.hpp"
#include "postprocess/summary/stopping_rule.hpp"

namespace clogflow::postprocess {
namespace {

using testing::Contains;
using testing::HasSubstr;

/// A neck 100 um wide and a seed for each burst.
RunGroup group_of(const std::vector<FirstBurst>& bursts) {
  RunGroup group;
  group.scene.unclog.protocol = UnclogProtocol::stop;
  group.scene.geometry.neck_width = 1e-4;
  group.scale = {1, 0.5};
  for (const FirstBurst& burst : bursts) {
    SeedRecord& record = group.records.emplace_back();
    record.seed = group.records.size();
    record.window = {0, 10};
    record.protocol = UnclogProtocol::stop;
    record.first_burst = burst;
  }
  return group;
}

const StatisticsRequest quick{.p_value_replicates = 0, .resampling = {.replicates = 200}};

FirstBurst clogged(std::size_t size, double position) { return {size, true, position, 0.40, 0.42}; }

TEST(FirstBurstStatistics, by_hand) {
  // Positions: the neck's entrance is at 0; beyond a width upstream of it is -100 um.
  const RunGroup group =
      group_of({clogged(0, -2e-5), clogged(4, -2e-4), clogged(8, -9e-5), {12, false, {}, 0.46, 0.46}});
  const FirstBurstStatistics first = first_burst_statistics(group, quick);
  EXPECT_EQ(first.seeds, 4U);
  EXPECT_EQ(first.clogged, 3U);
  EXPECT_EQ(first.passages, 24U);
  EXPECT_EQ(first.largest, 12U);
  EXPECT_DOUBLE_EQ(first.hazard.value, 3.0 / 27);
  // S = 3/4 before trial 4, 1/2 before trial 8, 1/4 until the last, which is cut.
  EXPECT_DOUBLE_EQ(first.mean.mean.value, 4 * 0.75 + 4 * 0.5 + 4 * 0.25);
  EXPECT_TRUE(first.mean.is_restricted);
  EXPECT_EQ(first.survival.size(), 3U);
  EXPECT_EQ(first.hazard_bins.size(), 1U);
  EXPECT_NEAR(first.packing.flowing.value, 0.415, 1e-14);
  EXPECT_NEAR(first.packing.at_end.value, 0.43, 1e-14);
  EXPECT_LT(first.packing.flowing.low, 0.415);
  EXPECT_EQ(first.places.known, 3U);
  EXPECT_EQ(first.places.upstream, 1U);
  EXPECT_DOUBLE_EQ(first.places.share_upstream.high, share_from_counts(1, 3, 0.95).high);
  ASSERT_TRUE(first.geometric);
  EXPECT_EQ(first.verdict.words, geometric_verdict(*first.geometric).words);
}

TEST(FirstBurstStatistics, no_clog_leaves_bounds) {
  const FirstBurstStatistics first =
      first_burst_statistics(group_of({{40, false, {}, NAN, NAN}, {60, false, {}, NAN, NAN}}), quick);
  EXPECT_NEAR(first.hazard.high, 1 - std::pow(0.05, 0.01), 1e-12);
  EXPECT_NEAR(first.mean.mean.low, 1 / first.hazard.high - 1, 1e-12);
  EXPECT_FALSE(first.geometric);
  EXPECT_EQ(first.verdict.words, "not tested: no seed clogged");
  EXPECT_EQ(first.packing.flowing.note, "no seed shows it");
  EXPECT_EQ(first.places.share_upstream.note, "no run says where its clog stood");
  EXPECT_TRUE(first.survival.empty());
}

TEST(FirstBurstStatistics, notes_name_the_stop_and_starts_that_jammed) {
  RunGroup group = group_of({clogged(0, 0), clogged(4, 0), clogged(8, 0)});
  group.records[0].start_flowed = false;
  group.records[1].start_flowed = true;
  const auto notes = group_statistics(group, quick).notes;
  EXPECT_THAT(notes,
              Contains("1 of 3 seeds jammed before they had flowed as inlet.strain asks; they count as bursts of "
                       "their passages all the same"));
  EXPECT_THAT(notes, Contains(HasSubstr("runs end at their first clog")));
}

std::vector<Totals> totals_of_seeds(const RunGroup& group) {
  std::vector<Totals> seeds;
  for (const SeedRecord& record : group.records) seeds.push_back(totals_of({record}, group.scale));
  return seeds;
}

// Ten seeds of 10 passages each have no spread: ten clogs in 110 trials, known by their counts.
TEST(FirstBurstStatistics, quantities_and_the_rule_that_stops_an_ensemble) {
  const RunGroup group = group_of(std::vector<FirstBurst>(10, clogged(10, 0)));
  const GroupStatistics numbers = group_statistics(group, quick);
  const Estimate& mean = numbers.of("first_burst_mean").whole;
  EXPECT_EQ(mean.value, 10);
  const Estimate share = share_from_counts(10, 110, 0.95);
  EXPECT_NEAR(mean.low, 1 / share.high - 1, 1e-9);
  EXPECT_NEAR(mean.high, 1 / share.low - 1, 1e-9);
  EXPECT_NEAR(numbers.of("first_burst_hazard").whole.value, 1.0 / 11, 1e-14);
  EXPECT_EQ(numbers.of("share_permanent").whole.value, 1);
  EXPECT_FALSE(numbers.of("first_burst_mean").halves);
  const double error = (mean.high - mean.low) / 2 / 10;
  EXPECT_NEAR(StoppingRule("relative_error(first_burst_mean)<=0.5").value(totals_of_seeds(group)), error, 1e-9);
}

TEST(FirstBurstStatistics, a_mean_of_first_bursts_needs_a_clog) {
  const RunGroup group = group_of({{40, false, {}, NAN, NAN}, {60, false, {}, NAN, NAN}});
  const Estimate mean = estimate(*find_quantity("first_burst_mean"), {totals_of_seeds(group), quick.resampling});
  EXPECT_TRUE(std::isnan(mean.value) && std::isnan(mean.high));
  EXPECT_NEAR(mean.low, 1 / (1 - std::pow(0.05, 0.01)) - 1, 1e-9);
  EXPECT_EQ(mean.note, "no seed clogged");
  const Estimate none = estimate(*find_quantity("first_burst_mean"), {totals_of_seeds(group_of({clogged(0, 0)})), {}});
  EXPECT_EQ(none.value, 0);
}

}  // namespace
}  // namespace clogflow::postprocess
