// The power law on whole numbers: against closed values, independent fits, and its own definition.
#include <numbers>

#include <gmock/gmock.h>

#include "coupling/base/number_column.hpp"
#include "postprocess/laws/goodness_of_fit.hpp"
#include "postprocess/laws/hurwitz_zeta.hpp"
#include "postprocess/laws/power_law.hpp"
#include "postprocess/laws/tail_fit.hpp"
#include "postprocess/laws/zeta_tail.hpp"
#include "tests/postprocess/laws/samples.hpp"
#include "tests/test_data.hpp"

namespace clogflow::postprocess {
namespace {

using testing::HasSubstr;

TEST(HurwitzZeta, closed_values) {
  const double pi2 = std::numbers::pi * std::numbers::pi;
  EXPECT_NEAR(hurwitz_zeta(2, 1), pi2 / 6, 1e-14);
  EXPECT_NEAR(hurwitz_zeta(2, 2), pi2 / 6 - 1, 1e-14);
  EXPECT_NEAR(hurwitz_zeta(2, 0.5), pi2 / 2, 1e-13);
  EXPECT_NEAR(hurwitz_zeta(4, 1), pi2 * pi2 / 90, 1e-14);
  EXPECT_NEAR(hurwitz_zeta(3, 1), 1.2020569031595942854, 1e-14);  // Apery's constant
}

TEST(HurwitzZeta, recurrence_from_small_to_huge_arguments) {
  for (const double s : {1.01, 1.5, 2.5, 7.0, 40.0})
    for (const double q : {1.0, 3.0, 19.0, 22.0, 61.0, 1e4, 1e9})
      EXPECT_NEAR(scaled_zeta(s, q).value, 1.0 + std::pow((q + 1) / q, -s) * scaled_zeta(s, q + 1).value,
                  1e-13 * scaled_zeta(s, q).value)
          << s << " " << q;
}

// With q = 1 the scaled function is zeta(s) itself; digits of zeta'(2) and zeta''(2) from mpmath.
TEST(HurwitzZeta, derivatives) {
  const ScaledZeta z = scaled_zeta(2, 1);
  EXPECT_NEAR(z.slope, -0.9375482543158437537, 1e-14);
  EXPECT_NEAR(z.curvature, 1.989280234298901023, 1e-13);
}

SortedSample counts(const char* file) { return SortedSample(read_number_column(test_data(file)), Values::whole); }

// Exponents and distances of an independent fit (scipy.special.zeta, every candidate, every value).
TEST(DiscretePowerLaw, agrees_with_an_independent_fit) {
  const auto counted = fit_power_law(counts("cases/counts61.txt"));
  EXPECT_NEAR(counted.alpha, 2.594976, 1e-6);
  EXPECT_NEAR(counted.ks, 0.012007, 1e-6);
  EXPECT_EQ(counted.xmin, 1);
  const auto harsha = fit_power_law(counts("cases/harsha.txt"), 1.0);
  EXPECT_NEAR(harsha.alpha, 2.604577, 1e-6);
  EXPECT_NEAR(harsha.ks, 0.133190, 1e-6);
}

// Table 6.1 of Clauset et al.: 1.79(2) from 323(89) on, 1711 values; p = 1.00.
TEST(DiscretePowerLaw, flares_as_published) {
  const auto flares = counts("csn_flares.txt");
  const auto fit = fit_power_law(flares);
  EXPECT_NEAR(fit.alpha, 1.79, 0.005);
  EXPECT_NEAR(fit.sigma, 0.02, 0.005);
  EXPECT_EQ(fit.xmin, 323);
  EXPECT_EQ(fit.n_tail, 1711U);
  EXPECT_GT(goodness_of_fit(flares, fit, {.replicates = 100}), 0.9);
}

std::vector<double> zeta_sample(std::size_t n, double alpha, double xmin, RandomStream random) {
  const ZetaVariates variate(alpha, xmin);
  std::vector<double> values(n);
  for (double& x : values) x = variate(random);
  return values;
}

std::vector<double> geometric_sample(std::size_t n, double rate, RandomStream random) {
  std::vector<double> values(n);
  for (double& x : values) x = 1.0 + std::floor(-std::log(1.0 - random.uniform()) / rate);
  return values;
}

TEST(DiscretePowerLaw, exponent_of_a_sample_within_its_sigma) {
  for (const double xmin : {1.0, 5.0, 300.0}) {
    int within = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
      const SortedSample sample(zeta_sample(1000, 2.5, xmin, {seed, 7}), Values::whole);
      const auto fit = fit_power_law(sample, xmin);
      within += std::abs(fit.alpha - 2.5) <= fit.sigma ? 1 : 0;
    }
    EXPECT_NEAR(within, 68, 14) << xmin;  // binomial, three standard deviations
  }
}

/// Largest deviation at every whole number up to the largest value: the definition.
double distance_by_definition(const std::vector<double>& values, double alpha, double xmin) {
  double n = 0, largest = 0, top = 0;
  for (const double x : values) {
    n += x >= xmin ? 1 : 0;
    top = std::max(top, x);
  }
  for (double x = xmin; x <= top; ++x) {
    double below = 0;
    for (const double value : values) below += value >= xmin && value <= x ? 1 : 0;
    largest = std::max(largest, std::abs(1.0 - zeta_survival(alpha, xmin, x + 1) - below / n));
  }
  return largest;
}

TEST(DiscretePowerLaw, pruned_scan_is_exact) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    for (const auto& values :
         {zeta_sample(20 + 30 * seed, 2.8, 1, {seed, 0}), geometric_sample(20 + 30 * seed, 0.05, {seed, 1})}) {
      const SortedSample sample(values, Values::whole);
      const auto fit = fit_power_law(sample);
      double smallest = 2;
      for (std::size_t k = 0; k + 1 < sample.distinct().size(); ++k) {
        const double xmin = sample.value(sample.distinct()[k]);
        const double ks = distance_by_definition(values, fit_power_law(sample, xmin).alpha, xmin);
        EXPECT_NEAR(fit_power_law(sample, xmin).ks, ks, 1e-12);
        smallest = std::min(smallest, ks);
      }
      EXPECT_NEAR(fit.ks, smallest, 1e-12) << seed;
      EXPECT_TRUE(some_tail_is_closer(sample, std::nextafter(fit.ks, 1.0)));
      EXPECT_FALSE(some_tail_is_closer(sample, fit.ks));
    }
  }
}

// An exponent of 1.3 puts an eighth of the draws beyond the table, up to some 1e40.
TEST(ZetaVariates, have_the_survival_of_the_law) {
  constexpr std::size_t n = 20000;
  for (const double xmin : {1.0, 40.0}) {
    const auto values = zeta_sample(n, 1.3, xmin, {3, 3});
    for (const double x : {xmin, xmin + 1, xmin + 9, 1023 + xmin, 1024 + xmin, 1e5, 1e9}) {
      const auto reached = std::ranges::count_if(values, [&](double v) { return v >= x; });
      const double expected = zeta_survival(1.3, xmin, x);
      EXPECT_NEAR(static_cast<double>(reached) / n, expected, 4 * std::sqrt(expected * (1 - expected) / n) + 1e-12)
          << x;
    }
  }
}

TEST(DiscreteGoodnessOfFit, uniform_for_a_true_power_law) {
  int below_half = 0, below_tenth = 0;
  constexpr int trials = 100;
  for (std::uint64_t seed = 0; seed < trials; ++seed) {
    const SortedSample sample(zeta_sample(300, 2.2, 1, {seed, 11}), Values::whole);
    const double p = goodness_of_fit(sample, fit_power_law(sample, 1.0),
                                     {.replicates = 100, .seed = seed, .lower_end = LowerEnd::fixed});
    below_half += p < 0.5 ? 1 : 0;
    below_tenth += p < 0.1 ? 1 : 0;
  }
  EXPECT_NEAR(below_half, 50, 16);  // binomial, three standard deviations, and a little
  EXPECT_NEAR(below_tenth, 10, 10);
}

TEST(DiscreteGoodnessOfFit, small_for_geometric_counts) {
  const SortedSample sample(geometric_sample(1000, 0.2, {2, 2}), Values::whole);
  EXPECT_LT(goodness_of_fit(sample, fit_power_law(sample, 1.0), {.replicates = 200, .lower_end = LowerEnd::fixed}),
            0.01);
}

// 1, 1, 2 by hand: mean excess 1/3, so e^-rate = 1/4; p(1) = 3/4, p(2) = 3/16.
TEST(DiscreteRival, by_hand) {
  const auto test = discrete_power_law_against_exponential({1, 1, 2}, 1, 2);
  EXPECT_NEAR(test.rate, std::log(4.0), 1e-14);
  const double zeta = std::numbers::pi * std::numbers::pi / 6;
  const double power = -3 * std::log(zeta) + std::log(0.25);
  const double exponential = 2 * std::log(0.75) + std::log(3.0 / 16);
  EXPECT_NEAR(test.log_ratio, power - exponential, 1e-13);
}

TEST(DiscreteRival, finds_the_law_that_made_the_counts) {
  const auto winner = [](const std::vector<double>& values) -> std::string {
    return favoured(fit_tail(SortedSample(values, Values::whole), {.xmin = 1.0}).exponential);
  };
  EXPECT_EQ(winner(zeta_sample(500, 2.5, 1, {1, 1})), "power law");
  EXPECT_EQ(winner(geometric_sample(500, 0.1, {1, 2})), "exponential");
}

TEST(Recognised, whole_numbers_unless_all_are_large) {
  EXPECT_EQ(recognised({1, 2, 5}), Values::whole);
  EXPECT_EQ(recognised({1, 2, 5.5}), Values::continuous);
  EXPECT_EQ(recognised({1001, 2000}), Values::continuous);
  EXPECT_EQ(recognised({1000, 2000}), Values::whole);
}

TEST(DiscretePowerLaw, refusals) {
  EXPECT_THAT(refusal([] {
                SortedSample({1, 2.5}, Values::whole);
              }),
              HasSubstr("value 2.5 (a discrete power law needs whole numbers)"));
  EXPECT_THAT(refusal([] {
                fit_power_law(SortedSample({1, 2, 3}, Values::whole), 1.5);
              }),
              HasSubstr("xmin = 1.5 (must be whole, as the values are)"));
  const std::vector<double> equal(100, 7.0);
  for (const Values kind : {Values::whole, Values::continuous}) {
    EXPECT_THAT(refusal([&] { fit_power_law(SortedSample(equal, kind)); }), HasSubstr("all 100 values equal 7"));
    EXPECT_THAT(refusal([&] { fit_power_law(SortedSample(equal, kind), 7.0); }),
                HasSubstr("all values from xmin = 7 on equal it"));
  }
}

}  // namespace
}  // namespace clogflow::postprocess
