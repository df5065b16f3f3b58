// What this version does not model is refused, never ignored.
#include <gmock/gmock.h>

#include "dem/model.hpp"
#include "tests/coupling/refusal.hpp"
#include "tests/dem/channel_scene.hpp"

namespace clog::test {
namespace {

using testing::HasSubstr;

TEST(Model, RefusesWhatItDoesNotModel) {
  for (const auto& [overrides, key] : std::vector<std::pair<Overrides, std::string>>{
           {{"flow.pulsation.strength=0.5", "flow.pulsation.time=1 ms"}, "flow.pulsation"},
           {{"drag.fluctuation.strength=0.5", "drag.fluctuation.time=1 ms"}, "drag.fluctuation"},
           {{"fidelity.preset=fast"}, "fidelity.preset"},
           {{"fidelity.tolerance=0.05"}, "fidelity.tolerance"}}) {
    EXPECT_THAT(refusal([&] { make_model(short_channel_scene(overrides), nullptr, {}); }),
                HasSubstr(key + " is not modelled by this version"));
  }
}

TEST(Model, RefusesMoreParticlesThanAnyCoreFinishes) {
  EXPECT_THAT(refusal([] { make_model(short_channel_scene({"particles.diameter=1 nm"}), nullptr, {}); }),
              HasSubstr("the channel would hold"));
}

}  // namespace
}  // namespace clog::test
