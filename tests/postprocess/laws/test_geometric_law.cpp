// The test of the burst law must accept geometric sizes at its own rate and refuse others.
#include <cmath>
#include <random>

#include <gmock/gmock.h>

#include "postprocess/laws/geometric_law.hpp"
#include "tests/postprocess/laws/samples.hpp"

namespace clogflow::postprocess {
namespace {

TEST(GeometricLaw, distance_by_hand) {
  // Sizes 1, 1, 4: mean 2, P(s <= 1) = 1/2 against 2/3, P(s <= 3) = 7/8 against 2/3.
  EXPECT_NEAR(test_geometric({1, 1, 4}, 1, 1).ks, 7.0 / 8 - 2.0 / 3, 1e-12);
}

TEST(GeometricLaw, refuses_true_samples_as_often_as_it_says) {
  std::mt19937_64 engine(3);
  for (const double mean : {1.5, 20.0}) {
    std::geometric_distribution<std::size_t> failures(1 / mean);
    int refused = 0;
    constexpr int trials = 400;
    for (int k = 0; k < trials; ++k) {
      std::vector<std::size_t> sizes;
      for (int i = 0; i < 40; ++i) sizes.push_back(1 + failures(engine));
      refused += test_geometric(sizes, 100, static_cast<std::uint64_t>(k)).p_value < 0.1 ? 1 : 0;
    }
    EXPECT_GT(refused, 0.04 * trials) << mean;  // 10 % nominal, four binomial errors of 1.5 %
    EXPECT_LT(refused, 0.16 * trials) << mean;
  }
}

TEST(GeometricLaw, refuses_sizes_that_hardly_vary_and_an_excess_of_small_ones) {
  std::vector<std::size_t> narrow, mixed;
  for (std::size_t i = 0; i < 40; ++i) {
    narrow.push_back(80 + i);
    mixed.push_back(i % 2 == 0 ? 1 : 40 + 2 * i);
  }
  EXPECT_EQ(test_geometric(narrow, 200, 1).p_value, 0);
  EXPECT_EQ(test_geometric(mixed, 200, 1).p_value, 0);
}

TEST(GeometricLaw, bursts_of_one_particle_only) {
  const GeometricTest test = test_geometric({1, 1, 1, 1}, 50, 1);
  EXPECT_EQ(test.ks, 0);
  EXPECT_EQ(test.p_value, 1);
}

TEST(GeometricLaw, nothing_to_test) {
  EXPECT_EQ(refusal([] { test_geometric({}, 10, 1); }), "0 burst sizes, 10 replicates: nothing to test");
}

/// Counts from 0 on, cut after a number of trials that is uniform between 5 and 45.
std::vector<TrialCount> cut_sample(std::size_t n, std::mt19937_64& engine, double hazard) {
  std::geometric_distribution<std::size_t> passed(hazard);
  std::uniform_int_distribution<std::size_t> end(5, 45);
  std::vector<TrialCount> sample;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t whole = passed(engine), cut = end(engine);
    sample.push_back(whole < cut ? TrialCount{whole, true} : TrialCount{cut, false});
  }
  return sample;
}

TEST(CutGeometricLaw, distance_by_hand) {
  // Without cuts it is that of the sizes from 1 on.
  EXPECT_NEAR(test_geometric_trials({{0, true}, {0, true}, {3, true}}, 1, 1).ks, 7.0 / 8 - 2.0 / 3, 1e-12);
  // h = 3/15: S = 4/5 before trial 2, where the law has passed (4/5)^2.
  EXPECT_NEAR(test_geometric_trials({{0, true}, {2, true}, {2, false}, {3, true}, {5, false}}, 1, 1).ks, 0.8 - 0.64,
              1e-12);
}

// Twenty clog after 9, 180 are cut after 10, and twenty go on to 100 without any event: h = 20/4000, S ends level at
// 10/11, where the law has fallen to 0.995^100 = 0.606.
TEST(CutGeometricLaw, a_level_end_counts) {
  std::vector<TrialCount> sample(20, {9, true});
  sample.insert(sample.end(), 180, {10, false});
  sample.insert(sample.end(), 20, {100, false});
  const GeometricTest test = test_geometric_trials(sample, 200, 1);
  EXPECT_NEAR(test.ks, 10.0 / 11 - std::pow(0.995, 100), 1e-12);
  EXPECT_LT(test.p_value, 0.05);
}

TEST(CutGeometricLaw, refuses_true_samples_as_often_as_it_says) {
  std::mt19937_64 engine(5);
  int refused = 0;
  constexpr int trials = 300;
  for (int k = 0; k < trials; ++k) {
    const auto sample = cut_sample(40, engine, 0.05);
    refused += test_geometric_trials(sample, 100, static_cast<std::uint64_t>(k)).p_value < 0.1 ? 1 : 0;
  }
  EXPECT_GT(refused, 0.03 * trials);  // 10 % nominal, four binomial errors of 1.7 %
  EXPECT_LT(refused, 0.17 * trials);
}

TEST(CutGeometricLaw, refuses_a_hazard_that_grows) {
  std::vector<TrialCount> sample;
  for (std::size_t k = 0; k < 40; ++k) sample.push_back(k % 8 == 0 ? TrialCount{10, false} : TrialCount{20 + k, true});
  EXPECT_LT(test_geometric_trials(sample, 200, 1).p_value, 0.01);
}

// No event in trials 0 to 4, then one in ten.
TEST(MemorylessTail, begins_where_the_hazard_has_become_constant) {
  std::mt19937_64 engine(7);
  std::geometric_distribution<std::size_t> passed(0.1);
  std::vector<TrialCount> sample;
  for (int k = 0; k < 200; ++k) sample.push_back({5 + passed(engine), true});
  EXPECT_LT(test_geometric_trials(sample, 200, 1).p_value, 0.01);
  const auto tail = memoryless_tail(sample, 20, 200, {});
  ASSERT_TRUE(tail);
  EXPECT_GE(tail->from, 3U);
  EXPECT_LE(tail->from, 5U);
  EXPECT_LE(tail->hazard.low, 0.1);
  EXPECT_GE(tail->hazard.high, 0.1);
  EXPECT_EQ(tail->events, 200U);
  EXPECT_FALSE(memoryless_tail(sample, 201, 200, {}));
  // The law itself is its own tail, and who was cut before it is not in it.
  EXPECT_EQ(memoryless_tail({{3, true}, {0, false}}, 1, 10, {})->from, 0U);
  EXPECT_FALSE(memoryless_tail({{9, false}}, 0, 10, {}));
}

TEST(CutGeometricLaw, clogged_at_once_or_never) {
  EXPECT_EQ(test_geometric_trials(std::vector<TrialCount>(5, {0, true}), 50, 1).p_value, 1);
  EXPECT_EQ(refusal([] {
              test_geometric_trials(std::vector<TrialCount>{{7, false}}, 10, 1);
            }),
            "0 counts that an event ended, 10 replicates: nothing to test");
}

}  // namespace
}  // namespace clogflow::postprocess
