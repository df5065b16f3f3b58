// A column that drains, fed with made-up packings.
#include <gtest/gtest.h>

#include "dem/protocol/supply_watch.hpp"
#include "tests/dem/channel_scene.hpp"

namespace clogflow::test {
namespace {

/// d / v = 6.6 ms.
bool drains(SupplyWatch& watch, double time, double packing) {
  return watch.drains(time, [&] { return packing; });
}

TEST(SupplyWatch, EndsARunWhoseNeckIsDrained) {
  SupplyWatch watch(cheap_paper_scene({"inlet.start=flowing"}));
  EXPECT_FALSE(drains(watch, 0, 0.4));
  EXPECT_FALSE(drains(watch, 0.1, 0.21));
  EXPECT_FALSE(drains(watch, 0.2, 0.19));
  EXPECT_FALSE(drains(watch, 0.265, 0.19)) << "not yet ten tau";
  EXPECT_TRUE(drains(watch, 0.267, 0.19));
  EXPECT_TRUE(watch.drained());
}

TEST(SupplyWatch, ForgivesAGapThatCloses) {
  SupplyWatch watch(cheap_paper_scene({"inlet.start=flowing"}));
  EXPECT_FALSE(drains(watch, 0, 0.4));
  EXPECT_FALSE(drains(watch, 0.1, 0.1));
  EXPECT_FALSE(drains(watch, 0.15, 0.3));
  EXPECT_FALSE(drains(watch, 0.2, 0.1));
}

TEST(SupplyWatch, HasNothingToSayOfAnEmptyStartOrWithoutStrips) {
  for (const char* without : {"inlet.start=empty", "porosity.strips=0"}) {
    SupplyWatch watch(cheap_paper_scene({without}));
    EXPECT_FALSE(drains(watch, 0, 0.4));
    EXPECT_FALSE(drains(watch, 0.1, 0));
    EXPECT_FALSE(drains(watch, 1, 0));
  }
}

}  // namespace
}  // namespace clogflow::test
