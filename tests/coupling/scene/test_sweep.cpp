// Sweeps: which points, which folders, and what is refused.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "coupling/scene/sweep.hpp"
#include "tests/coupling/refusal.hpp"

namespace clogflow::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(Sweep, HasEveryCombination) {
  const auto points = sweep_points({"particles.diameter = 22 um, 33 um", "contact.friction.rolling=0.3,0.6"});
  ASSERT_EQ(points.size(), 4u);
  EXPECT_EQ(points[1].folder, "particles.diameter=22um,contact.friction.rolling=0.6");
  EXPECT_THAT(points[1].overrides, ElementsAre("particles.diameter=22 um", "contact.friction.rolling=0.6"));
  EXPECT_EQ(points[2].folder, "particles.diameter=33um,contact.friction.rolling=0.3");
  EXPECT_EQ(sweep_points({"fluid.density=900 kg/m3"})[0].folder, "fluid.density=900kgperm3");
}

TEST(Sweep, OfNothingIsOnePointInNoFolder) {
  const auto points = sweep_points({});
  ASSERT_EQ(points.size(), 1u);
  EXPECT_EQ(points[0].folder, "");
  EXPECT_TRUE(points[0].overrides.empty());
}

TEST(Sweep, RefusesWhatIsNone) {
  const auto said = [](const std::vector<std::string>& sweeps) { return refusal([&] { sweep_points(sweeps); }); };
  EXPECT_THAT(said({"particles.diameter"}), HasSubstr("(write key=value,value"));
  EXPECT_THAT(said({"particles.diametre=1 um"}),
              HasSubstr("(unknown key; the nearest known key is particles.diameter)"));
  EXPECT_THAT(said({"particles.diameter=1 um,,2 um"}), HasSubstr("(\"\" is no single value"));
  EXPECT_THAT(said({"body_force=[1 N,0 N,0 N]"}), HasSubstr("(\"[1 N\" is no single value"));
  EXPECT_THAT(said({"time.mass_scale=1,1"}), HasSubstr("(1 is given twice)"));
  EXPECT_THAT(said({"time.mass_scale=1", "time.mass_scale=2"}), HasSubstr("(the key is swept twice)"));
  EXPECT_THAT(said({"ensemble.seeds=1,2"}), HasSubstr("(is no property of a run: use --seeds)"));
  EXPECT_THAT(said({"particles.diameter=1 um,1um"}), HasSubstr("two points have one folder, particles.diameter=1um"));
  std::string values = "1";
  for (int k = 2; k <= 400; ++k) values += fmt::format(",{}", k);
  EXPECT_THAT(said({fmt::format("time.mass_scale={}", values), fmt::format("contact.restitution={}", values)}),
              HasSubstr("(more than 100000 points)"));
}

}  // namespace
}  // namespace clogflow::test
