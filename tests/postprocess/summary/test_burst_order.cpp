// Bursts of runs that clear their clogs: alike and independent, or not, and what that does to the interval of <s>.
#include <cmath>

#include <gmock/gmock.h>

#include "postprocess/summary/group_statistics.hpp"
#include "tests/postprocess/laws/samples.hpp"

namespace clogflow::postprocess {
namespace {

using testing::Contains;
using testing::HasSubstr;

/// A seed for each sequence of whole bursts.
RunGroup group_of(const std::vector<std::vector<std::size_t>>& sequences) {
  RunGroup group;
  group.scene.unclog.protocol = UnclogProtocol::restart;
  group.scale = {1, 0.5};
  for (const auto& sizes : sequences) {
    SeedRecord& record = group.records.emplace_back();
    record.seed = group.records.size();
    record.protocol = UnclogProtocol::restart;
    record.window = {0, static_cast<double>(sizes.size() + 1)};
    record.bursts.push_back({0, 0, 7, 0, BurstKind::first});
    for (const std::size_t size : sizes)
      record.bursts.push_back({static_cast<double>(record.bursts.size()), 0, size, 0, BurstKind::whole});
  }
  return group;
}

const StatisticsRequest quick{.p_value_replicates = 0, .resampling = {.replicates = 300}};

std::vector<std::size_t> drawn(std::size_t n, double mean, RandomStream random) {
  std::vector<std::size_t> sizes;
  for (const double x : exponential_sample(n, mean, random)) sizes.push_back(static_cast<std::size_t>(x));
  return sizes;
}

TEST(BurstOrder, fifths_by_hand) {
  std::vector<std::size_t> sizes;
  for (std::size_t k = 0; k < 20; ++k) sizes.push_back(k);
  const auto order = burst_order(group_of({sizes, sizes}), quick.resampling);
  ASSERT_TRUE(order);
  EXPECT_EQ(order->bursts, 40U);
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(order->fifths[k].bursts, 8U);
    EXPECT_DOUBLE_EQ(order->fifths[k].mean.value, 4 * static_cast<double>(k) + 1.5);
  }
  EXPECT_DOUBLE_EQ(order->trend.value, 1);
  EXPECT_LT(order->trend.p_value, 0.01);
  EXPECT_TRUE(order->depends);
}

TEST(BurstOrder, only_where_clogs_are_cleared_and_bursts_are_many) {
  const auto sizes = drawn(30, 9, {1, 1});
  RunGroup group = group_of({sizes});
  EXPECT_TRUE(burst_order(group, quick.resampling));
  group.scene.unclog.protocol = UnclogProtocol::stop;
  EXPECT_FALSE(burst_order(group, quick.resampling));
  EXPECT_FALSE(burst_order(group_of({drawn(19, 9, {1, 1})}), quick.resampling));
}

TEST(BurstOrder, independent_bursts_keep_their_interval) {
  const RunGroup group = group_of({drawn(30, 9, {1, 1}), drawn(30, 9, {1, 2}), drawn(30, 9, {1, 3})});
  const GroupStatistics numbers = group_statistics(group, quick);
  ASSERT_TRUE(numbers.burst_order);
  EXPECT_FALSE(numbers.burst_order->depends) << numbers.burst_order->words;
  EXPECT_THAT(numbers.burst_order->words, HasSubstr("no trend (p = "));
  EXPECT_EQ(numbers.of("mean_burst").whole.note, "");
}

// Three times ten bursts of 3 and ten of 30 in every seed: seeds agree, so they alone would leave the interval of the
// counts.
TEST(BurstOrder, bursts_that_depend_on_each_other_have_the_wider_interval) {
  std::vector<std::size_t> sizes;
  for (std::size_t k = 0; k < 60; ++k) sizes.push_back(k % 20 < 10 ? 3 : 30);
  const RunGroup group = group_of(std::vector(4, sizes));
  const GroupStatistics numbers = group_statistics(group, quick);
  ASSERT_TRUE(numbers.burst_order && numbers.burst_order->depends);
  EXPECT_LT(numbers.burst_order->memory.p_value, 0.01);
  const Estimate& mean = numbers.of("mean_burst").whole;
  EXPECT_DOUBLE_EQ(mean.value, 16.5);
  EXPECT_THAT(mean.note, HasSubstr("bursts are not independent"));
  EXPECT_THAT(numbers.notes, Contains(HasSubstr("bursts are not independent: trend with their number")));
  // 240 independent bursts of 3 or 30: 1.96 13.5/sqrt(240) = 1.7 on each side.
  EXPECT_GT(mean.high - mean.low, 2 * 2.2);
  const auto known = dependent_estimate(*find_quantity("mean_burst"), group, quick.resampling);
  EXPECT_EQ(known.low, mean.low);
}

TEST(BurstOrder, a_single_seed_has_an_interval_from_blocks) {
  std::vector<std::size_t> sizes;
  for (std::size_t k = 0; k < 60; ++k) sizes.push_back(2 + k / 2);
  const Estimate mean = group_statistics(group_of({sizes}), quick).of("mean_burst").whole;
  EXPECT_LT(mean.low, mean.value);
  EXPECT_GT(mean.high, mean.value);
}

}  // namespace
}  // namespace clogflow::postprocess
