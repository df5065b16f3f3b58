// Which moments of a burst are recorded, by hand.
#include <vector>

#include <gtest/gtest.h>

#include "coupling/base/archive.hpp"
#include "dem/protocol/burst_clock.hpp"

namespace clogflow {
namespace {

/// Steps of 1 from `from` to `to`, in which a particle passes at each multiple of `lapse`. \return when snapshots were
/// due
std::vector<int> recorded(BurstClock& clock, int from, int to, int lapse) {
  std::vector<int> moments;
  for (int now = from; now < to; ++now) {
    if (now % lapse == 0) clock.flows(now);
    if (!clock.due(now)) continue;
    clock.took();
    moments.push_back(now);
  }
  return moments;
}

TEST(BurstClock, AnIntervalApartFromTheFirstPassageUntilNothingHasPassedForAWhile) {
  BurstClock clock(2, 10);
  EXPECT_TRUE(recorded(clock, 1, 100, 1000).empty());
  clock.flows(100.5);
  EXPECT_EQ(recorded(clock, 101, 200, 1000), (std::vector<int>{101, 103, 105, 107, 109}));
  // The next burst begins anew.
  clock.flows(201);
  EXPECT_EQ(recorded(clock, 201, 204, 1000), (std::vector<int>{201, 203}));
}

TEST(BurstClock, ALongBurstIsRecordedEverMoreRarely) {
  BurstClock clock(1, 10);
  const std::vector<int> moments = recorded(clock, 0, 1000, 5);
  ASSERT_GE(moments.size(), 126u);
  EXPECT_EQ(moments[49], 49);
  EXPECT_EQ(moments[50] - moments[49], 1);
  EXPECT_EQ(moments[51] - moments[50], 2);
  EXPECT_EQ(moments[74], 50 + 2 * 24);
  EXPECT_EQ(moments[75], 50 + 2 * 25);
  EXPECT_EQ(moments[76] - moments[75], 4);
  // 50 + 25 (2 + 4 + 8 + 16) = 800 after 150 snapshots, then 32 apart: 800, 832, ... 992.
  EXPECT_EQ(moments.size(), 157u);
  EXPECT_EQ(moments.back(), 992);
}

TEST(BurstClock, OffAndFromTimeZeroAgain) {
  BurstClock off(0, 10);
  EXPECT_FALSE(off.on());
  EXPECT_TRUE(recorded(off, 0, 50, 5).empty());
  BurstClock clock(1, 10);
  clock.flows(500);
  clock.restart();
  EXPECT_FALSE(clock.due(501));
  EXPECT_EQ(recorded(clock, 0, 3, 1000), (std::vector<int>{0, 1, 2}));
}

TEST(BurstClock, GoesOnFromASavedState) {
  BurstClock whole(1, 10), before(1, 10), after(1, 10);
  std::vector<int> moments = recorded(before, 0, 77, 7);
  ArchiveWriter writer;
  writer(before);
  const std::string bytes = writer.bytes();
  ArchiveReader reader(bytes);
  reader(after);
  EXPECT_TRUE(after.is_valid());
  for (const int moment : recorded(after, 77, 300, 7)) moments.push_back(moment);
  EXPECT_EQ(moments, recorded(whole, 0, 300, 7));
}

}  // namespace
}  // namespace clogflow
