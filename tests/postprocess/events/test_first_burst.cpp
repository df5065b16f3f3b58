// The first burst of runs written by hand, under every protocol.
#include <cmath>

#include <gmock/gmock.h>

#include "coupling/scene/unclog_protocol.hpp"
#include "postprocess/events/seed_record.hpp"
#include "postprocess/summary/totals.hpp"

namespace clogflow::postprocess {
namespace {

constexpr double tau = 1;

Scene scene_with(UnclogProtocol protocol) {
  Scene scene;
  scene.unclog.protocol = protocol;
  scene.unclog.after = 5;
  scene.porosity.strips = 2;
  return scene;
}

/// Passages at 1, 2 and 3; near the neck 1 - eps = 0.40 at time 0, 0.42 at 2, 0.50 at 4, 0.54 at 8.
RunData three_passages(double end) {
  RunData run;
  run.end_time = end;
  run.passages.time = {1, 2, 3};
  run.passages.friction_off = {0, 0, 0};
  run.series.time = {0, 2, 4, 8};
  run.series.count = {1, 50, 100, 100};
  run.series.packing_fraction = {0.3, 0.4, 0.4, 0.4};
  run.series.porosity = {{0.7, 0.60}, {0.7, 0.58}, {0.7, 0.50}, {0.7, 0.46}};
  return run;
}

FirstBurst first_of(const RunData& run, UnclogProtocol protocol) {
  return first_burst_of(run, scene_with(protocol), {0, run.end_time}, tau);
}

TEST(FirstBurst, a_clog_that_ended_the_run) {
  RunData run = three_passages(4.5);
  run.record.clogged_at = 4.5;
  run.record.clog_position = -2e-5;
  const FirstBurst burst = first_of(run, UnclogProtocol::stop);
  EXPECT_EQ(burst.size, 3U);
  EXPECT_TRUE(burst.clogged);
  EXPECT_EQ(burst.clog_position, -2e-5);
  EXPECT_NEAR(burst.packing_flowing, 0.41, 1e-14);  // samples up to the last passage, at 3
  EXPECT_NEAR(burst.packing_at_end, 0.50, 1e-14);
  EXPECT_TRUE(as_trials(burst).ended);
}

TEST(FirstBurst, cut_by_the_end_of_the_run) {
  const FirstBurst burst = first_of(three_passages(3), UnclogProtocol::stop);
  EXPECT_EQ(burst.size, 3U);  // the last one at the end itself
  EXPECT_FALSE(burst.clogged);
  EXPECT_FALSE(burst.clog_position);
}

TEST(FirstBurst, clogged_at_once) {
  RunData run = three_passages(0.9);
  run.passages = {};
  run.record.clogged_at = 0.9;
  const FirstBurst burst = first_of(run, UnclogProtocol::stop);
  EXPECT_EQ(burst.size, 0U);
  EXPECT_TRUE(burst.clogged);
  EXPECT_TRUE(std::isnan(burst.packing_flowing));
  EXPECT_NEAR(burst.packing_at_end, 0.40, 1e-14);
}

// The first release at 2.5; a poke is over at once.
TEST(FirstBurst, ended_by_the_first_release_restart_or_poke) {
  for (const auto protocol : {UnclogProtocol::release, UnclogProtocol::restart, UnclogProtocol::poke}) {
    EXPECT_TRUE(clears_clogs(protocol));
    RunData run = three_passages(9);
    const double back = protocol == UnclogProtocol::poke ? 2.5 : 2.8;
    run.releases = {{2.5, 8}, {back, 8}, {0, 0}, {-3e-4, 0}};
    const FirstBurst burst = first_of(run, protocol);
    EXPECT_EQ(burst.size, 2U);
    EXPECT_TRUE(burst.clogged);
    EXPECT_EQ(burst.clog_position, -3e-4);
    EXPECT_NEAR(burst.packing_at_end, 0.42, 1e-14);
    const SeedRecord record = record_of(run, scene_with(protocol), {tau, 0.5});
    ASSERT_EQ(record.bursts.size(), 3U);
    EXPECT_EQ(record.bursts[1].size, 1U);
    EXPECT_EQ(record.bursts[1].start, back);
    EXPECT_EQ(totals_of(record, {tau, 0.5}, {0, 10}).releases, 1);  // the second burst is cut off
    EXPECT_EQ(record.lapses[1].end, LapseEnd::release);
    EXPECT_FALSE(first_of(three_passages(9), protocol).clogged);
  }
  EXPECT_FALSE(clears_clogs(UnclogProtocol::none) || clears_clogs(UnclogProtocol::stop));
}

TEST(FirstBurst, releases_before_the_channel_was_full_do_not_count) {
  RunData run = three_passages(9);
  run.releases = {{0.5, 2.5}, {0.6, 2.6}, {0, 0}, {-1, -2}};
  const FirstBurst burst = first_burst_of(run, scene_with(UnclogProtocol::release), {0.8, 9}, tau);
  EXPECT_EQ(burst.size, 2U);
  EXPECT_EQ(burst.clog_position, -2);
}

// Nothing passes after 3: a clog if the run goes on until 8, five tau later. An arrest of 20 before, which a passage
// ended, is none.
TEST(FirstBurst, without_a_protocol_the_clog_that_stays) {
  EXPECT_TRUE(first_of(three_passages(8), UnclogProtocol::none).clogged);
  EXPECT_FALSE(first_of(three_passages(7.9), UnclogProtocol::none).clogged);
  RunData run = three_passages(30);
  run.passages.time.push_back(23);
  run.passages.friction_off.push_back(0);
  EXPECT_EQ(first_of(run, UnclogProtocol::none).size, 4U);
  EXPECT_TRUE(first_of(run, UnclogProtocol::none).clogged);
  run.passages = {};
  EXPECT_EQ(first_of(run, UnclogProtocol::none).size, 0U);
  EXPECT_TRUE(first_of(run, UnclogProtocol::none).clogged);
  run.end_time = 4.9;
  EXPECT_FALSE(first_of(run, UnclogProtocol::none).clogged);
}

TEST(FirstBurst, near_the_neck_is_the_last_strip_before_it) {
  RunData run = three_passages(3);
  for (auto& strips : run.series.porosity) strips.push_back(0.9);  // the neck as a strip of its own
  EXPECT_NEAR(first_of(run, UnclogProtocol::stop).packing_flowing, 0.41, 1e-14);
  Scene scene = scene_with(UnclogProtocol::stop);
  scene.porosity.strips = 0;
  EXPECT_TRUE(std::isnan(first_burst_of(run, scene, {0, 3}, tau).packing_flowing));
}

TEST(FirstBurst, is_the_only_burst_of_a_run_that_stops) {
  RunData run = three_passages(4.5);
  run.record.clogged_at = 4.5;
  SeedRecord record = record_of(run, scene_with(UnclogProtocol::stop), {tau, 0.5});
  ASSERT_EQ(record.bursts.size(), 1U);
  EXPECT_EQ(record.bursts[0].size, 3U);
  EXPECT_EQ(record.bursts[0].kind, BurstKind::first);
  const Totals totals = totals_of(std::vector{record}, {tau, 0.5});
  EXPECT_EQ(totals.first_clogs, 1);
  EXPECT_EQ(totals.until_first, 3);
  EXPECT_EQ(totals.permanent, 1);  // known 1.5 tau after the last passage
  run.record.clogged_at.reset();
  record = record_of(run, scene_with(UnclogProtocol::stop), {tau, 0.5});
  EXPECT_EQ(record.bursts[0].kind, BurstKind::cut_off);
  EXPECT_EQ(totals_of(std::vector{record}, {tau, 0.5}).permanent, 0);
}

TEST(FirstBurst, belongs_to_the_first_half_of_its_run) {
  const SeedRecord record = record_of(three_passages(8), scene_with(UnclogProtocol::none), {tau, 0.5});
  EXPECT_EQ(totals_of(record, {tau, 0.5}, {0, 4}).until_first, 3);
  EXPECT_EQ(totals_of(record, {tau, 0.5}, {4, 8}).until_first, 0);
}

// A flowing start fills the channel behind a gate as a filled one does: nothing is left out.
TEST(FirstBurst, a_flowing_start_counts_from_time_0) {
  RunData run = three_passages(8);
  run.record.fill_time = 0.3;
  run.record.start_flowed = false;
  Scene scene = scene_with(UnclogProtocol::none);
  scene.inlet.enabled = true;
  scene.inlet.start = InletStart::flowing;
  EXPECT_EQ(end_of_filling(run, scene), 0);
  const SeedRecord record = record_of(run, scene, {tau, 0.5});
  EXPECT_EQ(record.filling_time, 0.3);
  EXPECT_EQ(record.start_flowed, false);
  scene.inlet.start = InletStart::empty;
  EXPECT_EQ(end_of_filling(run, scene), 4);
}

}  // namespace
}  // namespace clogflow::postprocess
