// A passage: each particle once, at the interpolated time and place.
#include <gtest/gtest.h>

#include "tests/dem/contact/wall_shapes.hpp"
#include "tests/dem/laboratory.hpp"

namespace clogflow::test {
namespace {

/// Spheres that fly through an STL tube (one far away triangle) past the plane x = 1.
Scene flight(const ScratchFile& stl) {
  Scene s = laboratory_scene({1e5, 0.3, 1000, 0.1}, 0.01);
  s.geometry.present = true;
  s.geometry.stl = stl.name();
  s.passages.plane = 1;
  s.time.end = 3;
  return s;
}

/// Two corners of a large bounding box as tiny triangles: walls that nothing touches.
const std::string far_triangles = R"(solid far
facet normal 0 0 1
 outer loop
  vertex -10 -10 -10
  vertex -9 -10 -10
  vertex -9 -9 -10
 endloop
endfacet
facet normal 0 0 1
 outer loop
  vertex 10 10 10
  vertex 9 10 10
  vertex 9 9 10
 endloop
endfacet
endsolid far
)";

TEST(Passages, AreCountedOnceAtTheTimeOfCrossing) {
  const ScratchFile stl(far_triangles, ".stl");
  Laboratory lab(flight(stl), {{.radius = 0.05, .x = 0, .y = 1, .z = 2, .vx = 0.7, .vy = 0.1},
                               {.radius = 0.05, .x = 0.5, .y = -1, .vx = 0.3},
                               {.radius = 0.05, .x = 0, .y = -3, .vx = -0.1},
                               {.radius = 0.05, .x = 0, .y = 5, .vx = 0.2}});
  const RunData run = lab->run();
  ASSERT_EQ(run.passages.id, (std::vector<std::int64_t>{0, 1}));
  EXPECT_NEAR(run.passages.time[0], 1 / 0.7, 1e-12);
  EXPECT_NEAR(run.passages.y[0], 1 + 0.1 / 0.7, 1e-12);
  EXPECT_NEAR(run.passages.z[0], 2, 1e-12);
  EXPECT_NEAR(run.passages.time[1], 0.5 / 0.3, 1e-12);
  EXPECT_EQ(run.passages.friction_off, (std::vector<std::uint8_t>{0, 0}));
}

// Lists last for 50 steps here: a crossing must be seen in its own step, not with the next lists.
TEST(Passages, AreSeenInTheStepOfTheCrossing) {
  const ScratchFile stl(far_triangles, ".stl");
  const std::vector<double> way = {0.00251, 0.01234, 0.0199, 0.02577};
  std::vector<Particle> slow;
  for (double w : way) slow.push_back({.radius = 0.05, .x = 1 - w, .y = 200 * w, .vx = 0.01});
  Laboratory lab(flight(stl), slow);
  const RunData run = lab->run();
  ASSERT_EQ(run.passages.id, (std::vector<std::int64_t>{0, 1, 2, 3}));
  for (std::size_t k = 0; k < way.size(); ++k) EXPECT_NEAR(run.passages.time[k], way[k] / 0.01, 1e-9);
}

TEST(Passages, ASecondCrossingDoesNotCount) {
  const ScratchFile stl(far_triangles, ".stl");
  Scene s = flight(stl);
  // Thrown through the plane at 1 m/s and pulled back through it at 2 m/s2.
  s.time.end = 1.2;
  s.body_force = {-2 * 1000 * M_PI / 6 * 1e-3, 0, 0};
  Laboratory lab(s, {{.radius = 0.05, .x = 0.9, .vx = 1}});
  const RunData run = lab->run();
  EXPECT_LT(run.snapshots.back().position[0], 1);
  EXPECT_EQ(run.passages.id.size(), 1u);
}

}  // namespace
}  // namespace clogflow::test
