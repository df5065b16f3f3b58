// A coarse-grained porosity: the kernel by hand, uniform packs and lone spheres in channels, what a particle feels.
#include <numbers>

#include <gmock/gmock.h>

#include "coupling/base/source_folder.hpp"
#include "coupling/geometry/channel_geometry.hpp"
#include "coupling/geometry/channel_shape.hpp"
#include "dem/fluid/fluid.hpp"
#include "dem/fluid/local_porosity.hpp"
#include "dem/physics/porosity.hpp"
#include "tests/coupling/refusal.hpp"
#include "tests/dem/channel_scene.hpp"

namespace clogflow::test {
namespace {

constexpr double pi = std::numbers::pi;

TEST(GaussianKernel, HasItsIntegralAndItsWidth) {
  double sum = 0, square = 0;
  for (double x = -9; x < 9; x += 1e-3) {
    sum += 1e-3 * gaussian_kernel(x, 1.5);
    square += 1e-3 * x * x * gaussian_kernel(x, 1.5);
  }
  EXPECT_NEAR(sum, 1, 1e-8);
  EXPECT_NEAR(square, 2.25, 1e-6);
  // exp(-(1 / 1.5)^2 / 2) / (1.5 sqrt(2 pi))
  EXPECT_NEAR(gaussian_kernel(1, 1.5), 0.2129653, 1e-7);
  EXPECT_EQ(gaussian_kernel(-1, 1.5), gaussian_kernel(1, 1.5));
}

TEST(GaussianKernel, OfALoneSphereAtItsCentre) {
  // pi/6 / (2 pi 1.5^2)^1.5 and pi/6 / (2 pi 0.5^2)^1.5
  EXPECT_NEAR(own_solid_fraction(1, 1.5), 0.00985043, 1e-8);
  EXPECT_NEAR(own_solid_fraction(2, 1), 0.26596152, 1e-8);
}

/// A straight duct, -10 < x < 4, |y| < 4, 0 < z < 6.
Geometry duct() {
  Geometry g;
  g.present = true;
  g.neck_width = g.channel_width = 8;
  g.neck_height = 6;
  g.channel_length = 10;
  g.neck_length = 4;
  return g;
}

LocalPorosity local_in(const Geometry& g, double width) {
  return {{channel_walls(g), channel_start(g), channel_end(g)}, width};
}

void add_sphere(Particles& p, const Vec3& at, double radius) {
  p.add({.id = static_cast<std::int64_t>(p.size()), .radius = radius, .x = at.x, .y = at.y, .z = at.z});
}

/// A simple cubic lattice of the given spacing wherever it is inside, half a spacing from the ends, floor and lid.
Particles lattice(const Geometry& g, double spacing, double radius) {
  const ChannelShape shape = channel_shape(g);
  Particles p;
  for (double x = shape.start() + spacing / 2; x < shape.end(); x += spacing)
    for (double y = -g.channel_width / 2 + spacing / 2; y < g.channel_width / 2; y += spacing)
      for (double z = spacing / 2; z < g.neck_height; z += spacing)
        if (y < shape.upper.distance(x) && -y < shape.lower.distance(x)) add_sphere(p, {x, y, z}, radius);
  return p;
}

TEST(LocalPorosity, OfALatticeIsUniformUpToTheWalls) {
  LocalPorosity local = local_in(duct(), 1.5);
  local.update(lattice(duct(), 1, 0.4));
  // 4/3 pi 0.4^3 in each cube of side 1.
  const double expected = 1 - 0.2680826;
  // The channel's own volume is looked up at places, which leaves out a thousandth.
  EXPECT_NEAR(local.at({-3, 0, 3}), expected, 1e-3 * 0.268);
  // Half a spacing from a wall the lattice stops as a sum stops short of an integral: by less than 2 % of the solid.
  const Vec3 near_walls[] = {{-3, 3.6, 3}, {-3, 0, 0.4}, {-3, -3.6, 5.6}, {-9.6, -3.6, 0.4}, {3.6, 3.6, 5.6}};
  for (const Vec3& at : near_walls) EXPECT_NEAR(local.at(at), expected, 0.02 * 0.268) << at.x << " " << at.y;
}

TEST(LocalPorosity, KnowsTheSpaceBetweenSlantedWalls) {
  // The paper's channel: a fine lattice of points, whatever the walls cut off it.
  Geometry g = short_channel_scene().geometry;
  g.channel_length = 300e-6 - narrowing_length(g);  // a whole number of spacings
  LocalPorosity local = local_in(g, 50e-6);
  const double spacing = 5e-6, radius = 2e-6;
  local.update(lattice(g, spacing, radius));
  const double solid = 4.0 / 3 * pi * radius * radius * radius / (spacing * spacing * spacing);
  for (const double x : {-250e-6, -80e-6, -30e-6, -5e-6, 5e-6, 50e-6, 95e-6}) {
    const double half = channel_shape(g).upper.distance(x);
    for (const double y : {0.0, 0.5 * half, -0.95 * half})
      EXPECT_NEAR((1 - local.at({x, y, 40e-6})) / solid, 1, 0.02) << x << " " << y;
  }
}

TEST(LocalPorosity, OfALoneSphereIsItsOwn) {
  for (const double moved : {0.0, 0.2, 0.37, 0.5}) {
    LocalPorosity local = local_in(duct(), 1);
    Particles p;
    const Vec3 at{-4 + moved, moved, 3 - moved};
    add_sphere(p, at, 0.5);
    local.update(p);
    // On a point of the grid (all three moved by 0 or 0.5) the kernel is narrower than on average over a cell, between
    // points wider: (1 - 1/12)^(-3/2) = 1.14 and (1 - 1/12 + 1/8)^(-3/2) = 0.94 by the
    // variances of SmoothGrid; and what is cut off beyond three widths is 1 % more.
    EXPECT_GT((1 - local.at(at)) / own_solid_fraction(1, 1), 0.93) << moved;
    EXPECT_LT((1 - local.at(at)) / own_solid_fraction(1, 1), 1.17) << moved;
    EXPECT_EQ(local.at({-9, 0, 0}), 1);
  }
}

TEST(LocalPorosity, OfASphereAtAWallIsDividedByWhatTheKernelSees) {
  LocalPorosity local = local_in(duct(), 1);
  Particles p;
  add_sphere(p, {-4, 0, 0.5}, 0.5);
  local.update(p);
  // Half a width from the wall the kernel has 0.69146 of its weight in the channel.
  EXPECT_NEAR((1 - local.at({-4, 0, 0.5})) / (own_solid_fraction(1, 1) / 0.69146), 1, 0.15);
}

TEST(LocalPorosity, DoesNotFlipWhenASphereCrossesACell) {
  LocalPorosity local = local_in(duct(), 1);
  const auto seen = [&](double x) {
    Particles p;
    add_sphere(p, {x, 0, 3}, 0.5);
    local.update(p);
    return local.at({x, 0, 3});
  };
  for (const double edge : {-4.0, -3.5, -3.0}) EXPECT_NEAR(seen(edge - 1e-9), seen(edge + 1e-9), 2e-7);
}

TEST(LocalPorosity, NeverFallsBelowWhatADragLawKnows) {
  LocalPorosity local = local_in(duct(), 0.5);
  Particles p;
  for (int k = 0; k < 9; ++k) add_sphere(p, {-4, 0, 3}, 0.5);
  local.update(p);
  EXPECT_EQ(local.at({-4, 0, 3}), static_cast<float>(least_porosity));
  EXPECT_TRUE(local.valid());
}

TEST(LocalPorosity, OfAFineKernelInALongChannelIsRefused) {
  EXPECT_THAT(refusal([] { local_in(duct(), 1e-3); }), testing::HasSubstr("porosity.width = 0.001 m"));
}

TEST(LocalPorosity, DecidesTheDragOfAParticle) {
  const double d = 0.2, eta = 0.5;
  Scene scene = laboratory_scene({.diameter = d}, 1e-6);
  scene.fluid.viscosity = eta;
  scene.drag.enabled = true;
  Fluid fluid(scene, FlowField(std::array<double, 3>{1, 2, 3}), {}, local_in(duct(), 0.5));
  Particles p;
  add_sphere(p, {-4, 0, 3}, d / 2);
  add_sphere(p, {-8, 0, 3}, d / 2);
  for (int k = 0; k < 400; ++k) add_sphere(p, {-4, 0.05 * (k % 20) - 0.5, 2.5 + 0.05 * (k / 20.0)}, d / 2);
  fluid.update_porosity(p);
  fluid.evaluate(p);
  const double stokes = 3 * pi * eta * d;
  for (const int i : {0, 1}) {
    const double eps = fluid.local().at(p[i].position());
    const double f = 10 * (1 - eps) / (eps * eps) + eps * eps * (1 + 1.5 * std::sqrt(1 - eps));
    EXPECT_NEAR(fluid.drag_force(i, {0, 0, 0}).y / (f * stokes * 2 / eps), 1, 1e-12);
  }
  EXPECT_LT(fluid.local().at(p[0].position()), 0.7);
  // pi/6 0.2^3 / (2 pi 0.5^2)^1.5, on a point of the grid 1.16 times that
  EXPECT_NEAR(fluid.local().at(p[1].position()), 1 - 1.155 * 0.0021277, 2e-5);
}

TEST(LocalPorosity, WorksWithoutStripsAndInAChannelFromAFile) {
  const Overrides no_strips{"porosity.method=local", "porosity.strips=0"};
  const Scene keys = short_channel_scene(no_strips);
  const FlowGrid flow = synthetic_flow(keys);
  const Fluid by_keys = make_fluid(keys, &flow);
  EXPECT_TRUE(by_keys.strips().empty());
  EXPECT_FALSE(by_keys.local().empty());
  const Scene stl = read_scene(source_folder() / "scenes" / "pore.toml",
                               {"flow.source=uniform", "inlet.start=empty", "porosity.method=local"});
  Fluid by_file = make_fluid(stl, nullptr);
  // 4/3 pi 2^3 in each cube of side 5, in the straight part and where the neck is 100 wide.
  Particles p;
  for (double x = -477.5e-6; x < 100e-6; x += 5e-6)
    for (double y = -147.5e-6; y < 150e-6; y += 5e-6)
      for (double z = 2.5e-6; z < 100e-6; z += 5e-6)
        if (x < -180e-6 || std::abs(y) < 50e-6) add_sphere(p, {x, y, z}, 2e-6);
  by_file.update_porosity(p);
  EXPECT_NEAR(by_file.local().at({-350e-6, 100e-6, 50e-6}), 1 - 0.268083, 0.01);
}

}  // namespace
}  // namespace clogflow::test
