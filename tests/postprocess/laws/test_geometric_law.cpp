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

}  // namespace
}  // namespace clogflow::postprocess
