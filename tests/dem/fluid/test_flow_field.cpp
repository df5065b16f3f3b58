// V0 from a grid: the nearest point, and a linear field that trilinear lookup must return exactly.
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "coupling/geometry/duct_flow.hpp"
#include "coupling/scene/grid_spacing.hpp"
#include "dem/fluid/flow_field.hpp"
#include "dem/fluid/fluid.hpp"
#include "dem/state/particles.hpp"
#include "tests/dem/laboratory.hpp"

namespace clogflow {
namespace {

Vec3 linear(const Vec3& x) { return {1 + 2 * x.x - x.y, 0.5 * x.z + x.y, 3 - x.x + x.y - 2 * x.z}; }

FlowGrid linear_grid() {
  FlowGrid grid;
  grid.points = {5, 4, 3};
  grid.origin = Vec3(-1, -0.5, 0.25);
  grid.spacing = 0.5;
  grid.velocity.resize(3 * 60);
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 5; ++i) {
        const Vec3 u = linear(grid.origin + grid.spacing * Vec3(i, j, k));
        for (int c = 0; c < 3; ++c) grid.velocity[3 * grid.index(i, j, k) + c] = static_cast<float>(u[c]);
      }
  return grid;
}

Vec3 at(const FlowField& field, const Vec3& x) {
  const auto u = field.at(x.x, x.y, x.z);
  return {u[0], u[1], u[2]};
}

// A square duct of side 1 along x, as the mapper fills it: solid points stand beside the walls in y.
FlowGrid duct_grid(int layers) {
  const DuctFlow duct(1, 1);
  FlowGrid grid;
  const double h = 1.0 / layers;
  grid.points = {2, layers + 2, layers};
  grid.origin = Vec3(0, -0.5 - h / 2, h / 2);
  grid.spacing = h;
  grid.velocity.resize(3 * static_cast<std::size_t>(2 * (layers + 2) * layers));
  for (int k = 0; k < layers; ++k)
    for (int j = 1; j <= layers; ++j)
      for (int i = 0; i < 2; ++i)
        grid.velocity[3 * grid.index(i, j, k)] = static_cast<float>(duct(grid.origin.y + j * h, grid.origin.z + k * h));
  return grid;
}

TEST(FlowField, ErrorOfReadingInTheNeckIsTheStatedOne) {
  const DuctFlow duct(1, 1);
  for (const int layers : {10, 16, 50})
    for (const Lookup lookup : {Lookup::nearest, Lookup::trilinear}) {
      const FlowGrid grid = duct_grid(layers);
      const FlowField field(grid, lookup);
      std::mt19937 random(7);
      std::uniform_real_distribution<double> across(-0.5, 0.5);
      double squares = 0;
      constexpr int places = 4000;
      for (int n = 0; n < places; ++n) {
        const double y = across(random), z = 0.5 + across(random);
        squares += std::pow(field.at(0.5, y, z)[0] - duct(y, z), 2) / places;
      }
      // 8 % is the law's own; 4000 places add a few.
      EXPECT_NEAR(neck_lookup_error(lookup, 1.0 / layers, 1) / std::sqrt(squares), 1, 0.15) << layers;
      EXPECT_NEAR(spacing_for_error(lookup, neck_lookup_error(lookup, 1.0 / layers, 1), 1), 1.0 / layers, 1e-12);
    }
}

TEST(FlowField, TrilinearReturnsALinearField) {
  const FlowGrid grid = linear_grid();
  const FlowField field(grid, Lookup::trilinear);
  for (const Vec3& x : {Vec3(-1, -0.5, 0.25), Vec3(-0.77, 0.31, 0.6), Vec3(1, 1, 1.25), Vec3(0.249, -0.01, 0.99)})
    EXPECT_LT((at(field, x) - linear(x)).norm(), 1e-6) << "the grid holds floats";
}

TEST(FlowField, NearestReturnsTheNearestPoint) {
  const FlowGrid grid = linear_grid();
  const FlowField field(grid, Lookup::nearest);
  EXPECT_LT((at(field, {-0.76, -0.26, 0.49}) - linear({-1, -0.5, 0.25})).norm(), 1e-6);
  EXPECT_LT((at(field, {-0.74, -0.24, 0.51}) - linear({-0.5, 0, 0.75})).norm(), 1e-6);
}

TEST(FlowField, OutsideTheNearestFaceCounts) {
  const FlowGrid grid = linear_grid();
  for (const Lookup lookup : {Lookup::nearest, Lookup::trilinear}) {
    const FlowField field(grid, lookup);
    EXPECT_LT((at(field, {-9, 0, 0.25}) - linear({-1, 0, 0.25})).norm(), 1e-6);
    EXPECT_LT((at(field, {9, 9, 9}) - linear({1, 1, 1.25})).norm(), 1e-6);
  }
}

TEST(FlowField, HalfVorticityOfTheLinearField) {
  // curl = (dw/dy - dv/dz, du/dz - dw/dx, dv/dx - du/dy) = (1 - 0.5, 0 + 1, 0 + 1)
  const FlowGrid grid = linear_grid();
  const auto w = FlowField(grid, Lookup::trilinear).half_vorticity(0, 0.25, 0.75);
  EXPECT_NEAR(w[0], 0.25, 1e-6);
  EXPECT_NEAR(w[1], 0.5, 1e-6);
  EXPECT_NEAR(w[2], 0.5, 1e-6);
}

TEST(FlowField, UniformAndNone) {
  EXPECT_EQ(FlowField().at(1, 2, 3), (std::array<double, 3>{0, 0, 0}));
  EXPECT_EQ(FlowField(std::array<double, 3>{1, 2, 3}).at(9, 9, 9), (std::array<double, 3>{1, 2, 3}));
}

/// The lookup of the hot loop and the one for single places are the same, in every instruction set.
TEST(FlowField, ManyPlacesAtOnceAsOneByOne) {
  const FlowGrid grid = linear_grid();
  const FlowField field(grid, Lookup::nearest);
  Particles particles;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-2, 2);
  for (int k = 0; k < 37; ++k)
    particles.add({.id = k, .radius = 0.5 + k, .x = place(random), .y = place(random), .z = place(random)});
  // Of two strips that meet at x = 0, and of a neck from 0.6 on.
  const double speed_up[3] = {2, 3, 11}, drag_per_radius[3] = {5, 7, 13};
  std::vector<double> ux(37), uy(37), uz(37), drag(37);
  FlowTask task{pointers(particles), nullptr,   {},        0,         {},         -1, 1, 1, 0.6, speed_up,
                drag_per_radius,     ux.data(), uy.data(), uz.data(), drag.data()};
  ASSERT_TRUE(field.set_nearest(task));
  EXPECT_FALSE(FlowField(grid, Lookup::trilinear).set_nearest(task));
  for (const Kernels* kernels : {&kernels_x86_64, &select_kernels()}) {
    kernels->sample_nearest(task);
    for (int k = 0; k < 37; ++k) {
      const Vec3 u = at(field, {particles[k].x, particles[k].y, particles[k].z});
      const int strip = (particles[k].x >= 0) + (particles[k].x >= 0.6);
      EXPECT_EQ(ux[k], speed_up[strip] * u.x) << kernels->name << " " << k;
      EXPECT_EQ(uy[k], speed_up[strip] * u.y);
      EXPECT_EQ(uz[k], speed_up[strip] * u.z);
      EXPECT_EQ(drag[k], drag_per_radius[strip] * particles[k].radius);
    }
  }
}

/// Paper Eq. (4) by hand: half of the first strip is solid, eps = 0.5 and f = 20.515; the second is all but empty.
TEST(Fluid, EveryStripHasItsPorosity) {
  const FlowGrid grid = linear_grid();
  const Scene scene = test::laboratory_scene({.diameter = 0.2}, 1e-6);
  for (const FlowField& field : {FlowField(std::array<double, 3>{1, 2, 3}), FlowField(grid, Lookup::nearest)}) {
    Scene s = scene;
    s.fluid.viscosity = 0.5;
    s.drag.enabled = true;
    const double sphere = std::numbers::pi / 6 * 0.2 * 0.2 * 0.2;
    Fluid fluid(s, field, PorosityStrips(-1, 1, {2 * sphere, 1e9 * sphere}));
    Particles particles;
    particles.add({.id = 0, .radius = 0.1, .x = -0.5, .y = 0, .z = 0.75});
    particles.add({.id = 1, .radius = 0.1, .x = 0.5, .y = 0, .z = 0.75});
    fluid.update_porosity(particles);
    fluid.evaluate(particles);
    const double stokes = 3 * std::numbers::pi * 0.5 * 0.2;
    const Vec3 dense = at(field, {-0.5, 0, 0.75}), loose = at(field, {0.5, 0, 0.75});
    EXPECT_NEAR(fluid.drag_force(0, {0, 0, 0}).x, 20.515 * stokes * dense.x / 0.5,
                1e-4 * 20.515 * stokes * dense.norm());
    EXPECT_NEAR(fluid.drag_force(0, {0, 0, 0}).z, 20.515 * stokes * dense.z / 0.5,
                1e-4 * 20.515 * stokes * dense.norm());
    EXPECT_NEAR(fluid.drag_force(1, {0, 0, 0}).x, stokes * loose.x, 1e-4 * stokes * loose.norm());
  }
}

}  // namespace
}  // namespace clogflow
