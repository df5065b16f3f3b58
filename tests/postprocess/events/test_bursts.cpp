// Lapses, bursts and totals of passages written by hand.
#include <gmock/gmock.h>

#include "postprocess/events/bursts.hpp"
#include "postprocess/events/lapses.hpp"
#include "postprocess/laws/distributions.hpp"
#include "postprocess/summary/quantities.hpp"
#include "tests/postprocess/laws/samples.hpp"

namespace clogflow::postprocess {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

RunData run_with(std::vector<double> times, double end) {
  RunData run;
  run.passages.time = std::move(times);
  run.passages.friction_off.assign(run.passages.time.size(), 0);
  run.end_time = end;
  return run;
}

std::vector<std::size_t> sizes(const std::vector<Burst>& bursts) {
  std::vector<std::size_t> result;
  for (const auto& burst : bursts) result.push_back(burst.size);
  return result;
}

std::vector<BurstKind> kinds(const std::vector<Burst>& bursts) {
  std::vector<BurstKind> result;
  for (const auto& burst : bursts) result.push_back(burst.kind);
  return result;
}

TEST(Lapses, last_one_is_censored_by_the_end) {
  const auto lapses = lapses_of(run_with({1, 1.5, 4}, 10), {0, 10});
  ASSERT_EQ(lapses.size(), 3U);
  EXPECT_EQ(lapses[1].duration, 2.5);
  EXPECT_EQ(lapses[1].end, LapseEnd::passage);
  EXPECT_EQ(lapses[2].duration, 6);
  EXPECT_EQ(lapses[2].end, LapseEnd::run);
  EXPECT_TRUE(as_observation(lapses[2]).censored);
  EXPECT_EQ(arrests_of(lapses, 2.5).size(), 2U);  // T = T_min is a clog
}

TEST(Lapses, a_release_cuts_them_and_what_it_shakes_loose_starts_none) {
  auto run = run_with({1, 5.1, 5.2, 5.6}, 10);
  run.releases.off = {5};
  run.releases.on = {5.5};
  run.passages.friction_off = {0, 1, 1, 0};
  const auto lapses = lapses_of(run, {0, 10});
  ASSERT_EQ(lapses.size(), 2U);
  EXPECT_EQ(lapses[0].duration, 4);
  EXPECT_EQ(lapses[0].end, LapseEnd::release);
  EXPECT_EQ(lapses[1].start, 5.6);
  EXPECT_STREQ(name(lapses[0].end), "release");
}

TEST(Lapses, before_the_window_nothing_counts) {
  EXPECT_EQ(lapses_of(run_with({1, 2, 3}, 4), {1.5, 4}).size(), 2U);
  EXPECT_THAT(refusal([] { lapses_of(run_with({2, 1}, 3), {0, 3}); }), HasSubstr("passages are not in order of time"));
}

TEST(Bursts, between_clogs) {
  // T_min = 1: three passages, clog, one, clog, two and the run ends while they flow.
  const auto bursts = bursts_between_clogs(run_with({0.1, 0.2, 0.3, 2, 4, 4.5}, 5), {0, 5}, 1.0);
  EXPECT_THAT(sizes(bursts), ElementsAre(3, 1, 2));
  EXPECT_THAT(kinds(bursts), ElementsAre(BurstKind::first, BurstKind::whole, BurstKind::cut_off));
  EXPECT_NEAR(bursts[0].duration, 0.2, 1e-15);
  EXPECT_EQ(bursts[1].start, 2);
}

TEST(Bursts, a_clog_at_the_end_makes_the_last_one_whole) {
  const auto bursts = bursts_between_clogs(run_with({0.1, 2, 2.1}, 5), {0, 5}, 1.0);
  EXPECT_THAT(kinds(bursts), ElementsAre(BurstKind::first, BurstKind::whole));
  EXPECT_TRUE(bursts_between_clogs(run_with({}, 5), {0, 5}, 1.0).empty());
}

RunData released() {
  // First burst of 2; release at 5: 1 while off, then 3; release at 20: none; release at 30: 2 and
  // the end.
  auto run = run_with({1, 2, 5.1, 6, 7, 9, 31, 32}, 33);
  run.passages.friction_off = {0, 0, 1, 0, 0, 0, 0, 0};
  run.releases.off = {5, 20, 30};
  run.releases.on = {5.5, 20.5, 30.5};
  return run;
}

TEST(Bursts, after_releases) {
  const auto bursts = bursts_after_releases(released(), {0, 33}, 4.0);
  EXPECT_THAT(sizes(bursts), ElementsAre(2, 3, 0, 2));
  EXPECT_THAT(kinds(bursts), ElementsAre(BurstKind::first, BurstKind::whole, BurstKind::whole, BurstKind::cut_off));
  EXPECT_EQ(bursts[1].while_off, 1U);
  EXPECT_EQ(bursts[1].start, 5.5);
  EXPECT_EQ(bursts[1].duration, 3);
}

TEST(Bursts, at_rest_before_the_end_is_whole) {
  EXPECT_EQ(bursts_after_releases(released(), {0, 33}, 0.5).back().kind, BurstKind::whole);
  EXPECT_THAT(kinds(bursts_after_releases(run_with({1}, 9), {0, 9}, 2)), ElementsAre(BurstKind::cut_off));
}

SeedRecord record_of_releases() {
  SeedRecord record;
  record.window = {0, 33};
  record.protocol = UnclogProtocol::release;
  record.lapses = lapses_of(released(), record.window);
  record.bursts = bursts_after_releases(released(), record.window, 4.0);
  record.passages = 8;
  record.releases = 3;
  record.first_burst.size = 2;
  record.first_burst.clogged = true;
  return record;
}

double value(const char* key, const Totals& totals) {
  for (const auto& quantity : quantities()) {
    if (quantity.key == key) return quantity.value(totals);
  }
  throw Error(key);
}

TEST(Totals, releases_by_hand) {
  const auto totals = totals_of(record_of_releases(), {2.0, 1.0}, {0, 33});
  EXPECT_EQ(value("mean_burst", totals), 3);  // the first and the cut-off burst do not count
  EXPECT_EQ(value("mean_burst_with_zeros", totals), 1.5);
  EXPECT_EQ(value("mean_burst_censored", totals), 5);  // (3 + 2)/1
  EXPECT_EQ(value("share_failed", totals), 0.5);
  EXPECT_EQ(value("passages_while_off", totals), 0.5);
  EXPECT_NEAR(value("flow_rate", totals), 7.0 / 33.0, 1e-15);
  // T_min = 1: lapses 1, 3 (cut by the release), 1, 2, 11 (cut), 1, 1 (cut by the end): all are
  // arrests.
  EXPECT_EQ(totals.arrests, 7);
  EXPECT_EQ(totals.censored, 3);
  EXPECT_NEAR(value("alpha_fixed", totals), 1 + 4 / std::log(3.0 * 2.0 * 11.0), 1e-14);
  EXPECT_EQ(value("share_permanent", totals), 0);
}

TEST(Totals, halves_add_up_to_the_whole) {
  const auto record = record_of_releases();
  const ClogScale scale{3, 1.5};
  auto sum = totals_of(record, scale, {0, 16.5}) + totals_of(record, scale, {16.5, 33});
  sum.seeds = 1;
  const auto all = totals_of(record, scale, {0, 33});
  for (const auto& quantity : quantities()) {
    EXPECT_DOUBLE_EQ(quantity.value(sum), quantity.value(all)) << quantity.key;
  }
}

// Passages at 1 and 2, then nothing until 20: the arrest began in the first half, and fills the second.
TEST(Totals, the_time_of_an_arrest_belongs_to_where_it_passes) {
  SeedRecord record;
  record.window = {0, 20};
  record.lapses = lapses_of(run_with({1, 2}, 20), record.window);
  const ClogScale scale{4, 2};
  EXPECT_EQ(value("share_clogged", totals_of(record, scale, {0, 10})), 0.8);
  EXPECT_EQ(value("share_clogged", totals_of(record, scale, {10, 20})), 1);
}

TEST(Totals, a_clog_that_outlives_the_run_is_permanent) {
  SeedRecord record;
  record.window = {0, 20};
  record.lapses = lapses_of(run_with({1, 2}, 20), record.window);
  record.passages = 2;
  EXPECT_EQ(totals_of(record, {2.0, 1.0}, record.window).permanent, 1);
  EXPECT_EQ(totals_of(record, {4.0, 2.0}, record.window).permanent, 0);  // 18 s is less than 5 tau
  SeedRecord silent;
  silent.window = {0, 20};
  EXPECT_EQ(totals_of(silent, {2.0, 1.0}, silent.window).permanent, 1);
}

TEST(Distributions, bursts_on_whole_particles) {
  // Mean 2, few bursts: the first bin is as wide as the mean, the next 2.5 rounded up.
  const auto bins = burst_histogram({1, 1, 2, 4});
  ASSERT_EQ(bins.size(), 2U);
  EXPECT_EQ(bins[0].from, 0.5);
  EXPECT_EQ(bins[0].to, 2.5);
  EXPECT_EQ(bins[0].count, 3U);
  EXPECT_DOUBLE_EQ(bins[0].density, 0.375);
  EXPECT_EQ(bins[1].to, 5.5);
  EXPECT_EQ(bins[1].count, 1U);
}

TEST(Distributions, logarithmic_bins_integrate_to_one) {
  const auto bins = logarithmic_histogram(pareto_sample(1000, 2.0, {1, 1}));
  double integral = 0;
  for (const auto& bin : bins) integral += bin.density * (bin.to - bin.from);
  EXPECT_NEAR(integral, 1.0, 1e-12);
  EXPECT_TRUE(logarithmic_histogram({0.0}).empty());
  EXPECT_TRUE(burst_histogram({}).empty());
}

}  // namespace
}  // namespace clogflow::postprocess
