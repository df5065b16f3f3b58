// Drag laws by name: values worked out by hand, and what a particle of a scene feels.
#include <cmath>

#include <gmock/gmock.h>

#include "coupling/scene/scene_keys.hpp"
#include "dem/physics/drag_law.hpp"
#include "tests/coupling/refusal.hpp"
#include "tests/dem/laboratory.hpp"

namespace clogflow::test {
namespace {

TEST(DragLaws, StokesKnowsNoNeighbours) { EXPECT_EQ(find_drag_law("stokes").factor({0.4, 3}), 1); }

TEST(DragLaws, BeetstraAtRestIsHoef) {
  for (const double porosity : {0.4, 0.6, 1.0})
    EXPECT_EQ(find_drag_law("beetstra").slow_factor(porosity), find_drag_law("hoef").slow_factor(porosity));
}

TEST(DragLaws, BeetstraWorkedOutByHand) {
  // eps = 0.5, Re = 10: 20.51517 + 0.413 * 10 / 6 * (2 + 0.75 + 8.4 * 10^-0.343) / (1 + 10^1.5 * 10^-1.5)
  // = 20.51517 + 0.688333 * 6.563112 / 2 = 22.77397
  EXPECT_NEAR(find_drag_law("beetstra").factor({0.5, 10}), 22.77397, 2e-5);
  // A lone sphere at Re = 1: 1 + 0.413 / 24 * (1 + 8.4) / 2 = 1.08088
  EXPECT_NEAR(find_drag_law("beetstra").factor({1, 1}), 1.08088, 1e-5);
}

TEST(DragLaws, OfUnequalSpheresWorkedOutByHand) {
  const UnequalSpheres total{true}, without_gradient{false};
  // eps = 0.4, y = 2: 0.4 x 2 + 0.6 x 4 + 0.064 x 0.4 x 8; y = 1/2: 0.2 + 0.15 + 0.0032
  EXPECT_NEAR(total.factor(0.4, 2), 3.4048, 1e-12);
  EXPECT_NEAR(total.factor(0.4, 0.5), 0.3532, 1e-12);
  EXPECT_NEAR(total.factor(0.4, 1), 1.0256, 1e-12);
  EXPECT_NEAR(without_gradient.factor(0.4, 2), 2.512, 1e-12);
  // What the gradient pushes is in proportion to the volume: (1 - eps) y^2 f 3 pi eta d of F.
  for (const double y : {0.5, 1.0, 2.0})
    EXPECT_NEAR(total.factor(0.7, y) - 0.7 * without_gradient.factor(0.7, y), 0.3 * y * y, 1e-12);
  // A lone sphere is alone, whatever its size; nothing jumps on the way.
  EXPECT_EQ(total.factor(1, 0.5), 1);
  EXPECT_NEAR(total.factor(0.9 + 1e-9, 2), total.factor(0.9, 2), 1e-7);
}

TEST(DragLaws, EveryWordOfASceneHasARow) {
  for (const std::string_view word : std::get<WordSlot>(find_key("drag.law")->slot).words)
    EXPECT_EQ(find_drag_law(word).word, word);
  EXPECT_THAT(refusal([] { find_drag_law("magic"); }), testing::HasSubstr("has no row"));
}

/// Speed of a resting sphere of 1 mm in flowing water after the first kick [m/s].
double felt(const char* law, double speed) {
  Scene scene = laboratory_scene({1e7, 0.3, 1000, 1e-3}, 1e-6);
  scene.fluid.viscosity = 1e-3, scene.fluid.density = 1000;
  scene.flow.source = FlowSource::uniform;
  scene.flow.velocity = {speed, 0, 0};
  scene.drag.enabled = true;
  scene.drag.law = law;
  Laboratory lab(scene, {{.radius = 5e-4}});
  lab.step();
  return lab.velocity(0).x;
}

TEST(DragLaws, ASphereFeelsTheInertiaOfTheFluidUnderBeetstraAlone) {
  // Re = rho v d / eta = 1 at 1 mm/s.
  const double stokes = felt("stokes", 1e-3);
  EXPECT_GT(stokes, 0);
  EXPECT_EQ(felt("hoef", 1e-3), stokes);
  EXPECT_NEAR(felt("beetstra", 1e-3) / stokes, 1.08088, 1e-5);
}

}  // namespace
}  // namespace clogflow::test
