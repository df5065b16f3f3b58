// A scene printed for the eye is the same scene.
#include <gmock/gmock.h>

#include "coupling/base/source_folder.hpp"
#include "coupling/scene/readable_scene.hpp"
#include "tests/coupling/flow_scene.hpp"

namespace clogflow {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

TEST(ReadableScene, SaysQuantitiesAsPeopleDo) {
  const std::string text = readable_scene(effective_scene(flow_scene()));
  EXPECT_THAT(text, AllOf(HasSubstr("half_angle = \"60 deg\"\n"), HasSubstr("diameter = \"33 um\"\n"),
                          HasSubstr("mean_velocity = \"5 mm/s\"\n"), HasSubstr("youngs_modulus = \"3 MPa\"\n"),
                          HasSubstr("viscosity = \"1.8 mPa s\"\n"), HasSubstr("poisson_ratio = 0.35\n"),
                          Not(HasSubstr("rad\"")), Not(HasSubstr("e-0"))));
}

TEST(ReadableScene, IsReadBackToTheSameScene) {
  for (const char* name : {"paper.toml", "campaign.toml", "pore.toml"}) {
    const std::string text = effective_scene(read_scene(source_folder() / "scenes" / name, {}));
    // The folder of the scene, from which files are found, is that of its name.
    const std::string again = (source_folder() / "scenes" / "again.toml").string();
    EXPECT_EQ(effective_scene(parse_scene(readable_scene(text), again)), text) << name;
  }
  for (const char* angle : {"60 deg", "33.333 deg", "1 rad", "0.1 rad", "1.0471975511965979 rad"}) {
    const std::string text = effective_scene(flow_scene({std::string("geometry.half_angle=") + angle}));
    EXPECT_EQ(effective_scene(parse_scene(readable_scene(text), "again")), text) << angle;
  }
}

TEST(ReadableScene, TouchesNothingButQuantities) {
  const std::string text =
      "body_force = [\"1e-09 N\", \"0 N\", \"0 N\"]\n# \"0.001 m\" = note\n[particles]\ninitial = "
      "\"0.001 m\"\n"
      "unknown = \"0.001 m\"\ndiameter = \"no length\"\n\nno end";
  EXPECT_EQ(readable_scene(text),
            "body_force = [\"1 nN\", \"0 N\", \"0 N\"]\n# \"0.001 m\" = note\n[particles]\ninitial "
            "= \"0.001 m\"\n"
            "unknown = \"0.001 m\"\ndiameter = \"no length\"\n\nno end");
}

}  // namespace
}  // namespace clogflow
