// A channel from an STL file in the solver: where particles enter, where they leave, what closes it.
#include <gmock/gmock.h>

#include "coupling/channel_shape.hpp"
#include "coupling/source_folder.hpp"
#include "dem/inlet.hpp"
#include "dem/simulation.hpp"
#include "tests/coupling/refusal.hpp"

namespace clog::test {
namespace {

Scene pore(Overrides overrides = {}) {
  overrides.insert(overrides.begin(), {"flow.source=uniform", "time.end=1 ms", "inlet.start=empty"});
  return read_scene(source_folder() / "scenes" / "pore.toml", overrides);
}

TEST(StlScene, HasTheSameEndsGateAndStripsAsAChannelOfKeys) {
  const Scene scene = pore();
  const Model model = make_model(scene, nullptr, {});
  EXPECT_NEAR(model.domain.low.x(), -480e-6, 1e-9);
  EXPECT_NEAR(model.domain.outlet, 100e-6, 1e-9);
  EXPECT_NEAR(model.domain.passage, 50e-6, 1e-9);
  EXPECT_TRUE(model.walls_note.empty()) << model.walls_note;
  ASSERT_EQ(model.gate.size(), 2u);
  for (const Triangle& t : model.gate)
    for (const Vec3& corner : t.corner) {
      EXPECT_EQ(corner.x(), 0);
      EXPECT_NEAR(std::abs(corner.y()), 50e-6, 1e-9);
    }
  // The straight part alone, by hand: 300 x 300 x 100 um3.
  EXPECT_NEAR(channel_volume(scene, -480e-6, -180e-6) / 9e-12, 1, 1e-6);
  const Fluid fluid = make_fluid(scene, nullptr);
  EXPECT_EQ(fluid.strips().porosity().size(), 3u);
}

TEST(StlScene, ParticlesEnterBetweenTheWalls) {
  const Scene scene = pore();
  const Model model = make_model(scene, nullptr, {});
  const Fluid fluid = make_fluid(scene, nullptr);
  Inlet inlet(model);
  Particles p;
  Random random{3};
  inlet.scatter(p, random);
  EXPECT_GT(p.size(), 100u);
  const double r = scene.particles.diameter / 2;
  for (std::size_t i = 0; i < p.size(); ++i) {
    EXPECT_GE(p[i].x - r, -480.001e-6);
    EXPECT_LE(p[i].x + r, -179.9e-6);
    EXPECT_LE(std::abs(p[i].y) + r, 150.001e-6);
  }
}

TEST(StlScene, RunsWithoutAFlowFile) {
  Simulation simulation(pore({"time.end=200 us"}), nullptr, 1);
  simulation.run();
  EXPECT_GT(simulation.particles().size(), 5u);
}

}  // namespace
}  // namespace clog::test
