// The power-law fit against published fits, synthetic laws and its own definition.
#include <gmock/gmock.h>

#include "coupling/base/number_column.hpp"
#include "postprocess/laws/goodness_of_fit.hpp"
#include "postprocess/laws/pareto_tail.hpp"
#include "postprocess/laws/power_law.hpp"
#include "tests/postprocess/laws/samples.hpp"
#include "tests/test_data.hpp"

namespace clogflow::postprocess {
namespace {

using testing::HasSubstr;

PowerLawFit published(const char* file) { return fit_power_law(SortedSample(read_number_column(test_data(file)))); }

TEST(PowerLaw, plfit_continuous_as_published) {
  const auto fit = published("csn_plfit_continuous.txt");
  EXPECT_NEAR(fit.alpha, 2.53282, 5e-6);  // the digits given
  EXPECT_NEAR(fit.xmin, 1.43628, 5e-6);
  EXPECT_EQ(fit.n_tail, 5844U);
  EXPECT_NEAR(fit.ks, 0.007117, 5e-7);
  EXPECT_NEAR(fit.sigma, 1.53282 / std::sqrt(5844.0), 1e-6);
}

TEST(PowerLaw, flares_and_cities_as_published) {
  const auto flares = published("csn_flares.txt");
  EXPECT_NEAR(flares.alpha, 1.79, 0.005);
  EXPECT_DOUBLE_EQ(flares.xmin, 323.0);
  const auto cities = published("csn_cities.txt");
  EXPECT_NEAR(cities.alpha, 2.37, 0.005);
  EXPECT_NEAR(cities.xmin, 52460.0, 5.0);
}

// The package `powerlaw` counts equal values once and gets 2.2 at 14.92e3; Clauset et al. publish
// 2.5 at 111.92e3 (table 6.1), which is our rule.
TEST(PowerLaw, ties_are_treated_as_in_plfit) {
  const auto surnames = published("csn_surnames.txt");
  EXPECT_NEAR(surnames.alpha, 2.5, 0.05);
  EXPECT_NEAR(surnames.xmin, 111.92e3, 5.0);
}

// Five values by hand: tail 1, 2, 2, 4 with x_min = 1 has sum of ln = ln 16, so alpha = 1 + 4/ln
// 16; (x)^-(alpha-1) = exp(-4 ln x/ln 16): F(2) = 1 - 1/e, F(4) = 1 - 1/e^2. Ties: 2 stands at 1/4
// and 2/4.
TEST(PowerLaw, ties_by_hand) {
  const SortedSample sample({2, 1, 4, 2});
  const auto tail = ParetoTail::of(sample, 0, 1.0);
  EXPECT_NEAR(tail.alpha, 1.0 + 4.0 / std::log(16.0), 1e-14);
  const double at_first_two = 1.0 - std::exp(-1.0) - 0.25;
  EXPECT_NEAR(tail.deviation(sample, 1, tail.law_at(sample, 1)), at_first_two, 1e-14);
  EXPECT_NEAR(tail.deviation(sample, 2, tail.law_at(sample, 2)), 1.0 - std::exp(-1.0) - 0.5, 1e-14);
  EXPECT_NEAR(ks_distance_all_points(sample, tail), at_first_two, 1e-14);
}

/// The scan as its definition says, without any pruning.
PowerLawFit every_candidate(const SortedSample& sample) {
  PowerLawFit best;
  best.ks = 2;
  const auto& distinct = sample.distinct();
  for (std::size_t k = 0; k + 1 < distinct.size(); ++k) {
    const auto tail = ParetoTail::of(sample, distinct[k], sample.value(distinct[k]));
    const double ks = ks_distance_all_points(sample, tail);
    if (ks < best.ks) best = {tail.alpha, sample.value(distinct[k]), 0, ks, sample.size() - tail.first, sample.size()};
  }
  return best;
}

std::vector<double> with_ties(std::vector<double> values) {
  for (double& x : values) x = std::ceil(8.0 * x) / 8.0;
  return values;
}

TEST(PowerLaw, pruned_scan_is_exact) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const std::size_t n = 6 + 37 * seed;
    std::vector<std::vector<double>> samples{pareto_sample(n, 1.5 + 0.05 * static_cast<double>(seed), {seed, 0}),
                                             exponential_sample(n, 3.0, {seed, 1})};
    samples.push_back(with_ties(samples[0]));
    samples.push_back(with_ties(samples[1]));
    for (const auto& values : samples) {
      const SortedSample sample(values);
      const auto fit = fit_power_law(sample);
      const auto definition = every_candidate(sample);
      EXPECT_EQ(fit.xmin, definition.xmin) << "seed " << seed;
      EXPECT_EQ(fit.ks, definition.ks) << "seed " << seed;
      EXPECT_TRUE(some_tail_is_closer(sample, std::nextafter(fit.ks, 1.0)));
      EXPECT_FALSE(some_tail_is_closer(sample, fit.ks));
    }
  }
}

TEST(PowerLaw, exponent_of_a_pareto_sample_within_its_sigma) {
  int within = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const auto fit = fit_power_law(SortedSample(pareto_sample(2000, 2.5, {seed, 7})), 1.0);
    within += std::abs(fit.alpha - 2.5) <= fit.sigma ? 1 : 0;
  }
  EXPECT_NEAR(within, 68, 14);  // binomial, three standard deviations
}

TEST(PowerLaw, two_hundred_thousand_values_in_seconds) {
  const auto fit = fit_power_law(SortedSample(pareto_sample(200000, 2.5, {3, 3})));
  EXPECT_NEAR(fit.alpha, 2.5, 0.05);
}

TEST(PowerLaw, scaling_the_data_scales_xmin_only) {
  auto values = pareto_sample(500, 2.2, {5, 5});
  const auto fit = fit_power_law(SortedSample(values));
  for (double& x : values) x *= 1024.0;  // a power of two: no rounding
  const auto scaled = fit_power_law(SortedSample(values));
  EXPECT_NEAR(scaled.alpha, fit.alpha, 1e-9);
  EXPECT_EQ(scaled.xmin, 1024.0 * fit.xmin);
}

TEST(PowerLaw, refusals) {
  EXPECT_THAT(refusal([] { SortedSample({1, 0, 2}); }), HasSubstr("value 0 (a power law needs positive"));
  EXPECT_THAT(refusal([] { SortedSample({1, -2}); }), HasSubstr("value -2"));
  EXPECT_THAT(refusal([] { SortedSample(std::vector<double>{}); }), HasSubstr("the sample is empty"));
  EXPECT_THAT(refusal([] {
                fit_power_law(SortedSample({1, 2, 3, 4}));
              }),
              HasSubstr("4 values (a fit needs at least 5)"));
  EXPECT_THAT(refusal([] { fit_power_law(SortedSample({3, 3, 3, 3, 3})); }), HasSubstr("all 5 values equal 3"));
  EXPECT_THAT(refusal([] { fit_power_law(SortedSample({1, 2, 3}), 3.0); }), HasSubstr("leaves 1 of 3 values"));
  EXPECT_THAT(refusal([] {
                fit_power_law(SortedSample({1, 3, 3}), 3.0);
              }),
              HasSubstr("all values from xmin = 3 on equal it"));
  EXPECT_THAT(refusal([] { fit_power_law(SortedSample({1, 3, 3}), -1.0); }), HasSubstr("xmin = -1 (must be positive)"));
  EXPECT_THAT(refusal([] {
                goodness_of_fit(SortedSample({1, 2, 3, 4, 5}), {}, {.replicates = 0});
              }),
              HasSubstr("0 bootstrap replicates"));
}

TEST(GoodnessOfFit, as_published_for_the_data_of_clauset) {
  // Table 6.1: flares 1.00, surnames 0.20; their and our p carry a bootstrap noise of about 0.03.
  const SortedSample surnames(read_number_column(test_data("csn_surnames.txt")));
  EXPECT_NEAR(goodness_of_fit(surnames, fit_power_law(surnames), {.replicates = 400}), 0.20, 0.08);
}

TEST(GoodnessOfFit, uniform_for_a_true_power_law) {
  int below_half = 0, below_tenth = 0;
  constexpr int trials = 100;
  for (std::uint64_t seed = 0; seed < trials; ++seed) {
    const SortedSample sample(pareto_sample(150, 2.5, {seed, 11}));
    const double p = goodness_of_fit(sample, fit_power_law(sample), {.replicates = 100, .seed = seed});
    below_half += p < 0.5 ? 1 : 0;
    below_tenth += p < 0.1 ? 1 : 0;
  }
  EXPECT_NEAR(below_half, 50, 16);  // binomial, three standard deviations, and a little
  EXPECT_NEAR(below_tenth, 10, 10);
}

TEST(GoodnessOfFit, small_for_exponential_data_with_fixed_xmin) {
  auto values = exponential_sample(1000, 1.0, {2, 2});
  for (double& x : values) x += 1.0;
  const SortedSample sample(values);
  EXPECT_LT(goodness_of_fit(sample, fit_power_law(sample, 1.0), {.replicates = 200, .lower_end = LowerEnd::fixed}),
            0.01);
}

TEST(GoodnessOfFit, small_for_a_sample_that_no_xmin_rescues) {
  // A log-uniform law has the density 1/x up to a sharp end: every tail is far from a power law.
  RandomStream random(4, 4);
  std::vector<double> values(2000);
  for (double& x : values) x = std::pow(10.0, random.uniform());
  const SortedSample sample(values);
  EXPECT_LT(goodness_of_fit(sample, fit_power_law(sample), {.replicates = 200}), 0.1);
}

TEST(GoodnessOfFit, same_seed_same_value) {
  const SortedSample sample(pareto_sample(300, 2.0, {9, 9}));
  const auto fit = fit_power_law(sample);
  const double once = goodness_of_fit(sample, fit, {.replicates = 100, .seed = 5});
  EXPECT_EQ(goodness_of_fit(sample, fit, {.replicates = 100, .seed = 5}), once);
}

}  // namespace
}  // namespace clogflow::postprocess
