// Rows by hand; that whole files have the size is tested in tests/python/test_terminal.py.
#include "dem/plan/disk_use.hpp"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "tests/dem/channel_scene.hpp"

namespace clogflow {
namespace {

using test::cheap_paper_scene;

/// 10 passages in 0.1 s, known to be over after another 0.02 s.
ExpectedBurst some_burst() {
  return {.unknown = "", .mean = 10, .spread = 1, .start = 0.03, .flow = 0.1, .proof = 0.02};
}

ExpectedBurst unknown_burst() { return {.unknown = "not measured"}; }

DiskUse use_of(std::vector<std::string> overrides, const ExpectedBurst& burst) {
  overrides.insert(overrides.begin(), {"output.snapshot_interval=2 s"});
  overrides.insert(overrides.end(), {"time.end=1 s", "output.series_interval=10 ms", "particles.diameter=50 um"});
  return disk_use(cheap_paper_scene(overrides), 1000, burst);
}

TEST(DiskUse, CountsSnapshotsAndRowsUntilTheEnd) {
  const DiskUse use = use_of({"unclog.protocol=none", "output.snapshot_interval=99 ms"}, unknown_burst());
  EXPECT_EQ(use.snapshot_count, 2 + 10);
  EXPECT_EQ(use.series_rows, 1 + 100);
  EXPECT_TRUE(use.is_at_most);
  // 12 snapshots of 1000 particles with 15 numbers of motion, of which 0.88 are left, and two that nearly vanish.
  EXPECT_NEAR(use.snapshots, 12e3 * 8 * (15 * 0.88 + 2 * 0.2) + 12 * 1500, 1);
  // 101 rows of 13 columns and 3 strips are not compressed.
  EXPECT_NEAR(use.series, 101 * 8 * (13 + 3), 1);
}

TEST(DiskUse, ARunThatStopsEndsWithItsFirstClog) {
  const DiskUse use = use_of({"unclog.protocol=stop", "inlet.start=flowing", "inlet.strain=10"}, some_burst());
  EXPECT_EQ(use.series_rows, 1 + 12);
  EXPECT_EQ(use.snapshot_count, 2);
  EXPECT_FALSE(use.is_at_most);
  // The start lets ten cubes of 100 um pass, in spheres of 50 um.
  EXPECT_NEAR(use.passage_count, 10 + 10 * 1e-12 / (std::numbers::pi / 6 * 1.25e-13), 1e-6);
}

TEST(DiskUse, BurstsHaveTheSnapshotsOfTheirClock) {
  // d / v = 10 ms at 5 mm/s: a burst of 0.13 s in which one restarts is 0.14 s, and 1 s has 6.67 of them.
  const DiskUse few = use_of({"unclog.protocol=restart", "output.burst_snapshots=10 ms"}, some_burst());
  EXPECT_NEAR(few.snapshot_count, 2 + 1 / 0.15 * 15, 7);
  // 140 intervals: 50 and 25 for each doubling.
  const DiskUse many = use_of({"unclog.protocol=restart", "output.burst_snapshots=1 ms"}, some_burst());
  EXPECT_NEAR(many.snapshot_count, 2 + 1 / 0.15 * (50 + 25 * std::log2(2.8)), 1e-6);
  const DiskUse most = use_of({"unclog.protocol=restart", "output.burst_snapshots=1 ms"}, unknown_burst());
  EXPECT_NEAR(most.snapshot_count, 2 + 1000, 1e-6);
}

TEST(DiskUse, GrowsWithParticlesAlone) {
  const Scene scene = cheap_paper_scene({"output.snapshot_interval=1 ms"});
  const DiskUse one = disk_use(scene, 1000, unknown_burst()), ten = disk_use(scene, 10000, unknown_burst());
  EXPECT_NEAR(ten.end_state / one.end_state, 10, 1e-9);
  EXPECT_EQ(ten.series, one.series);
  EXPECT_EQ(ten.passages, one.passages);
}

}  // namespace
}  // namespace clogflow
