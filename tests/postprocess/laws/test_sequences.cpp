// Trend and memory of sequences: by hand, and how often a test errs.
#include <cmath>

#include <gmock/gmock.h>

#include "postprocess/laws/sequences.hpp"
#include "tests/postprocess/laws/samples.hpp"

namespace clogflow::postprocess {
namespace {

TEST(Sequences, trend_by_hand) {
  // Of the six orders of three values two have |rho| = 1.
  const PermutationTest up = trend_within({{1, 5, 9}}, 3000, 1);
  EXPECT_DOUBLE_EQ(up.value, 1);
  EXPECT_NEAR(up.p_value, 1.0 / 3, 0.04);  // four binomial errors
  EXPECT_DOUBLE_EQ(trend_within({{1, 2, 3}, {3, 2, 1}}, 10, 1).value, 0);
  // Ranks 1.5, 1.5, 3 at places 1, 2, 3: (0.5 + 0 + 1)/sqrt(2 1.5).
  EXPECT_NEAR(trend_within({{4, 4, 7}}, 10, 1).value, 1.5 / std::sqrt(3.0), 1e-14);
}

TEST(Sequences, sequences_on_two_levels_are_no_trend_but_a_memory) {
  Sequences levels;
  RandomStream random(1, 3);
  for (int k = 0; k < 6; ++k) {
    levels.emplace_back();
    for (int i = 0; i < 12; ++i) levels.back().push_back((k % 2 ? 20 : 5) + random.uniform());
  }
  EXPECT_GT(trend_within(levels, 500, 1).p_value, 0.05);
  EXPECT_LT(memory_of(levels, 500, 1).p_value, 0.01);
  EXPECT_GT(memory_of(levels, 500, 1).value, 0.9);
}

// Mean 2.5: products 0.75 - 0.25 + 0.75 of three pairs, squares 5 of four values.
TEST(Sequences, memory_by_hand) {
  EXPECT_NEAR(successive_correlation({{1, 2, 3, 4}}), (1.25 / 3) / (5.0 / 4), 1e-14);
  EXPECT_NEAR(memory_of({{1, 2, 3, 4}}, 10, 1).value, 1.0 / 3, 1e-14);
  // The end of one is no neighbour of the start of the next: pairs (1, 3) and (3, 1) alone, mean 2.
  EXPECT_NEAR(successive_correlation({{1, 3}, {3, 1}}), -1, 1e-14);
}

TEST(Sequences, nothing_varies_or_nothing_follows) {
  for (const Sequences& still : {Sequences{{2, 2, 2}}, Sequences{{5}}, Sequences{}, Sequences{{}, {}}}) {
    EXPECT_EQ(trend_within(still, 10, 1).p_value, 1);
    EXPECT_EQ(memory_of(still, 10, 1).p_value, 1);
  }
  EXPECT_TRUE(std::isnan(successive_correlation({{1}, {2}})));
  EXPECT_EQ(refusal([] { trend_within({{1, 2}}, 0, 1); }), "0 permutations: nothing to compare with");
}

TEST(Sequences, independent_values_are_accused_as_often_as_the_test_says) {
  int trends = 0, memories = 0;
  constexpr int trials = 300;
  for (std::uint64_t seed = 0; seed < trials; ++seed) {
    Sequences sequences;
    for (std::uint64_t k = 0; k < 4; ++k) sequences.push_back(exponential_sample(10, 7, {seed, k}));
    trends += trend_within(sequences, 99, seed).p_value <= 0.1 ? 1 : 0;
    memories += memory_of(sequences, 99, seed).p_value <= 0.1 ? 1 : 0;
  }
  EXPECT_NEAR(trends, 0.1 * trials, 21);  // four binomial errors of 5.2
  EXPECT_NEAR(memories, 0.1 * trials, 21);
}

TEST(Sequences, a_drift_and_a_memory_are_found) {
  Sequences drifting, remembering;
  for (std::uint64_t k = 0; k < 4; ++k) {
    drifting.push_back(exponential_sample(60, 1, {k, 1}));
    for (std::size_t i = 0; i < 60; ++i) drifting.back()[i] *= 1 + static_cast<double>(i) / 8;
    remembering.push_back(exponential_sample(30, 1, {k, 2}));
    for (std::size_t i = 1; i < 30; ++i) remembering.back()[i] += 0.7 * remembering.back()[i - 1];
  }
  EXPECT_LT(trend_within(drifting, 500, 1).p_value, 0.01);
  EXPECT_LT(memory_of(remembering, 500, 1).p_value, 0.01);
  EXPECT_NEAR(memory_of(remembering, 500, 1).value, 0.7, 0.25);
}

}  // namespace
}  // namespace clogflow::postprocess
