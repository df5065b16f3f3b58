// What tests/fuzz found, kept: one test a finding.
#include <gmock/gmock.h>

#include "coupling/base/units.hpp"
#include "coupling/openfoam/foam_samples.hpp"
#include "tests/coupling/flow_scene.hpp"
#include "tests/coupling/refusal.hpp"
#include "tests/coupling/scene/scene_texts.hpp"

namespace clogflow::test {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(FoundByFuzzing, AMessageStaysOneLineWhateverItQuotes) {
  EXPECT_THAT(refusal([] { parse_quantity("1 a\nb\x1b[31m"); }),
              testing::AllOf(Not(HasSubstr("\n")), Not(HasSubstr("\x1b"))));
  EXPECT_THAT(refusal([] { parse_scene(channel, "a", {"inlet.\nsti"}); }), Not(HasSubstr("\n")));
}

// Finite as a double, infinite in the grid of floats.
TEST(FoundByFuzzing, ASampleTooLargeForTheGridIsRefused) {
  const ScratchFolder folder;
  write_file(folder.path() / "quarter_U.xy", "5e-06 5e-06 5e-06 1e300 0 0\n");
  const FlowLattice lattice{
      .spacing = 1e-5, .x_begin = -3, .x_end = 2, .x_sampled = -2, .y_sampled = 0, .half_width = 2, .height = 4};
  EXPECT_THAT(refusal([&] { read_foam_samples(folder.path() / "quarter_U.xy", lattice); }),
              HasSubstr("expected six finite numbers"));
}

}  // namespace
}  // namespace clogflow::test
