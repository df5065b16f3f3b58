#include "coupling/openfoam/foam_samples.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "coupling/base/text_file.hpp"
#include "coupling/flow/flow_flux.hpp"
#include "coupling/flow/grid_from_samples.hpp"
#include "coupling/flow/lookup_error.hpp"
#include "coupling/openfoam/flow_mesh.hpp"
#include "tests/coupling/flow_scene.hpp"
#include "tests/coupling/refusal.hpp"

namespace clogflow {
namespace {

using testing::HasSubstr;

FlowLattice small_lattice() {
  return {.spacing = 1e-5, .x_begin = -3, .x_end = 2, .x_sampled = -2, .y_sampled = 0, .half_width = 2, .height = 4};
}

std::string refusal_of(const std::string& text) {
  const ScratchFolder scratch;
  write_file(scratch.path() / "lattice_U.xy", text);
  return refusal([&] { read_foam_samples(scratch.path() / "lattice_U.xy", small_lattice()); });
}

TEST(FoamSamples, ReadsPointsByTheirCoordinates) {
  const ScratchFolder scratch;
  const auto file = scratch.path() / "lattice_U.xy";
  write_file(file, "# x y z Ux Uy Uz\n5e-06\t5e-06 1.5e-05 0.02 -1e-3 3e-4\n-1.5e-5 1.5e-5 5e-06 1 2 3\n");
  const FoamSamples samples = read_foam_samples(file, small_lattice());
  EXPECT_THAT(samples.points, testing::ElementsAre(4, 2, 2));
  const std::size_t at = samples.index(2, 0, 1);
  EXPECT_EQ(samples.found[at], 1);
  EXPECT_FLOAT_EQ(samples.velocity[at][1], -1e-3f);
  EXPECT_EQ(samples.found[samples.index(0, 1, 0)], 1);
  EXPECT_EQ(samples.found[samples.index(0, 0, 0)], 0);
}

TEST(FoamSamples, RefusesDamagedFilesByLine) {
  const std::string good = "5e-06 5e-06 5e-06 1 2 3\n";
  EXPECT_THAT(refusal_of(good + "5e-06 5e-06 1.5e-05 1 2\n"), HasSubstr("lattice_U.xy:2: \"5e-06 5e-06 1.5e-05 1 2\""));
  EXPECT_THAT(refusal_of(good + "5e-06 5e-06 1.5e"), HasSubstr("ends inside a line (cut short)"));
  EXPECT_THAT(refusal_of("5e-06 5e-06 5e-06 1 nan 3\n"), HasSubstr("expected six finite numbers"));
  EXPECT_THAT(refusal_of("5e-06 5e-06 5e-06 1 x 3\n"), HasSubstr("expected six finite numbers"));
  EXPECT_THAT(refusal_of("5e-06 5e-06 5e-06 1 2 3 4\n"), HasSubstr("more than six numbers"));
  EXPECT_THAT(refusal_of(good + good), HasSubstr("the point is given twice"));
  EXPECT_THAT(refusal_of("5e-06 6e-06 5e-06 1 2 3\n"),
              HasSubstr("not on the grid of the scene (samples of another case?)"));
  EXPECT_THAT(refusal_of("5e-03 5e-06 5e-06 1 2 3\n"), HasSubstr("not on the grid of the scene"));
}

TEST(FoamSamples, NamesTheFileThatIsMissing) {
  const ScratchFolder scratch;
  EXPECT_THAT(refusal([&] { foam_samples_file(scratch.path()); }), HasSubstr("lattice_U.xy is missing"));
}

// Samples whose velocity is (1 + x, y, z - height/2) in units of 100 um: the mirror images continue
// it.
FoamSamples linear_samples(const Scene& scene, const FlowLattice& lattice) {
  FoamSamples samples;
  samples.points = lattice.sampled();
  const auto [nx, ny, nz] = samples.points;
  samples.velocity.resize(static_cast<std::size_t>(nx) * ny * nz);
  samples.found.assign(samples.velocity.size(), 1);
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) {
        samples.velocity[samples.index(i, j, k)] = {
            static_cast<float>(1 + 1e4 * lattice.coordinate(i + lattice.x_sampled)),
            static_cast<float>(1e4 * lattice.coordinate(j)),
            static_cast<float>(1e4 * (lattice.coordinate(k) - scene.geometry.neck_height / 2))};
      }
    }
  }
  return samples;
}

class GridFromSamples : public testing::TestWithParam<const char*> {};

TEST_P(GridFromSamples, MirrorsTheQuarter) {
  const Scene scene = flow_scene({std::string("flow.grid_spacing=") + GetParam()});
  const FlowLattice lattice = flow_lattice(scene, flow_mesh(scene));
  const FlowGrid grid = grid_from_samples(scene, lattice, linear_samples(scene, lattice));
  for (int k = 0; k < grid.points[2]; ++k) {
    for (int j = 0; j < grid.points[1]; ++j) {
      for (int i = lattice.x_sampled - lattice.x_begin; i < grid.points[0]; ++i) {
        const Vec3 x = grid.origin + grid.spacing * Vec3(i, j, k);
        const float* u = &grid.velocity[3 * grid.index(i, j, k)];
        if (grid.solid[grid.index(i, j, k)]) {
          ASSERT_EQ(u[0], 0);
          continue;
        }
        ASSERT_NEAR(u[0], 1 + 1e4 * x.x, 1e-5);
        ASSERT_NEAR(u[1], 1e4 * x.y, 1e-5);
        ASSERT_NEAR(u[2], 1e4 * x.z - 0.5, 1e-5);
      }
    }
  }
}

// 20 layers, and 25: an odd number has one on the symmetry plane.
INSTANTIATE_TEST_SUITE_P(Layers, GridFromSamples, testing::Values("5 um", "4 um"));

TEST(GridFromSamples, FillsTheRestWithDevelopedFlow) {
  const Scene scene = flow_scene();
  const FlowLattice lattice = flow_lattice(scene, flow_mesh(scene));
  const FlowGrid grid = grid_from_samples(scene, lattice, linear_samples(scene, lattice));
  EXPECT_NEAR(grid_flux(grid, 0) / (5e-3 * 4e-8), 1, 2e-3);  // midpoint rule on 20 layers
  EXPECT_EQ(grid.velocity[1], 0);
  const int neck = grid.points[0] - 2;
  EXPECT_TRUE(grid.solid[grid.index(neck, 29, 5)]);
  EXPECT_FALSE(grid.solid[grid.index(neck, 30, 5)]);
  EXPECT_TRUE(grid.solid[grid.index(neck, 50, 5)]);
}

TEST(GridFromSamples, RefusesASampleMissingInTheFluid) {
  const Scene scene = flow_scene();
  const FlowLattice lattice = flow_lattice(scene, flow_mesh(scene));
  FoamSamples samples = linear_samples(scene, lattice);
  samples.found[samples.index(3, 2, 1)] = 0;
  EXPECT_THAT(refusal([&] { grid_from_samples(scene, lattice, samples); }),
              HasSubstr("inside the fluid (the samples file is incomplete)"));
}

// u = x^2 / h^2: second difference 2, slope 2 i; v = 3 y / h: slope 3.
TEST(LookupErrorOfAGrid, IsThatOfAParabolaAndALine) {
  FlowGrid grid;
  grid.points = {3, 3, 3};
  grid.spacing = 1;
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) {
        for (const int u : {i * i, 3 * j, 0}) grid.velocity.push_back(static_cast<float>(u));
        grid.solid.push_back(0);
      }
  const LookupError error = lookup_error(grid, 2);
  EXPECT_NEAR(error.trilinear, 2.0 / 12 / 2, 1e-12);
  EXPECT_NEAR(error.nearest, std::sqrt((4 + 9) / 12.0) / 2, 1e-12);
  grid.solid[grid.index(0, 1, 1)] = 1;
  EXPECT_EQ(lookup_error(grid, 2).nearest, 0) << "beside a wall the fluid's own error is not defined";
}

}  // namespace
}  // namespace clogflow
