// A flow solved for one rate serves another: through `clog run`, as a user types it.
#include <gmock/gmock.h>

#include "tests/faults/program.hpp"

namespace clogflow::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(RescaledRun, RefusesAnotherRateUnlessToldToScale) {
  const SmallJob job({"time.end=10 ms"});
  const Overrides slower{"--set", "flow.mean_velocity=4 mm/s"};
  const Program refused = job.start("refused", "1", slower);
  EXPECT_EQ(refused.wait(), 1);
  EXPECT_THAT(refused.said(), AllOf(HasSubstr("the flow file belongs to another scene"),
                                    HasSubstr("\"5 mm/s\", this scene has"), HasSubstr("\"4 mm/s\"")));
  EXPECT_EQ(std::ranges::count(refused.said(), '\n'), 1) << refused.said();

  Overrides scaled = slower;
  scaled.insert(scaled.end(), {"--set", "flow.rescale=true"});
  const Program run = job.start("scaled", "1", scaled);
  EXPECT_EQ(run.wait(), 0) << run.said();
  // The neck's Reynolds number is 1.18 at 5 mm/s: 0.236 less, at 2.9 % for each unit.
  EXPECT_THAT(run.said(), HasSubstr("the flow is scaled by 0.8; that leaves out 0.68 % of the neck's mean velocity"));

  // The particles see the slower flow: the run is that of a flow made for its own rate.
  const SmallJob own({"time.end=10 ms", "flow.mean_velocity=4 mm/s", "flow.rescale=true",
                      "porosity.update_interval=10 us", "output.series_interval=1 ms"});
  EXPECT_EQ(own.complete("own", "1"), "");
  const RunData a = read_run_file(job.path("scaled") / run_file_name(1)),
                b = read_run_file(own.path("own") / run_file_name(1));
  EXPECT_EQ(a.scene_text, b.scene_text);
  ASSERT_EQ(a.series.time.size(), b.series.time.size());
  // Scaled numbers are rounded once more, to 1e-7: the packs differ, not what fills the channel.
  EXPECT_NEAR(static_cast<double>(a.series.count.front()), static_cast<double>(b.series.count.front()), 3);

  const Program fast = job.start("fast", "1", {"--set", "flow.rescale=true", "--set", "flow.mean_velocity=6 mm/s"});
  EXPECT_EQ(fast.wait(), 1);
  EXPECT_THAT(fast.said(), HasSubstr("Reynolds number is 1.42, and the error of scaling is known up to 1.2"));
}

}  // namespace
}  // namespace clogflow::test
