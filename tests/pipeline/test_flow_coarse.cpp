// A flow on a coarse mesh through OpenFOAM and the mapper: laws that hold on any mesh.
#include <algorithm>
#include <cmath>
#include <ostream>

#include <gmock/gmock.h>

#include "coupling/duct_flow.hpp"
#include "coupling/foam_case_writer.hpp"
#include "coupling/map_flow.hpp"
#include "coupling/text_file.hpp"
#include "tests/coupling/flow_scene.hpp"
#include "tests/coupling/refusal.hpp"
#include "tests/pipeline/flow_case.hpp"

namespace clog {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// Index of the plane of the grid nearest to x.
int plane(const FlowGrid& grid, double x) {
  return static_cast<int>(std::lround((x - grid.origin.x()) / grid.spacing));
}

// Largest difference of the axial velocity in a plane from developed flow, over the mean there.
double distance(const FlowGrid& grid, int i, const DuctFlow& duct, double mean) {
  double worst = 0;
  for (int k = 0; k < grid.points[2]; ++k) {
    for (int j = 0; j < grid.points[1]; ++j) {
      const Vec3 x = grid.origin + grid.spacing * Vec3(i, j, k);
      if (grid.solid[grid.index(i, j, k)]) continue;
      const double u = grid.velocity[3 * grid.index(i, j, k)];
      worst = std::max(worst, std::abs(u / mean - duct(x.y(), x.z())));
    }
  }
  return worst;
}

struct Shape {
  const char* name;
  Overrides overrides;
  double neck_width, neck_height, wide;
};

void PrintTo(const Shape& shape, std::ostream* out) { *out << shape.name; }

class CoarseFlow : public testing::TestWithParam<Shape> {};

TEST_P(CoarseFlow, ConservesMassAndDevelops) {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "case";
  const Shape& shape = GetParam();
  write_foam_case(flow_scene(shape.overrides), folder, foam_template());
  const ShellResult run = solve(folder);
  ASSERT_EQ(run.status, 0) << run.output;
  const FlowGrid grid = map_flow(folder);

  const double rate = 5e-3 * shape.wide * shape.neck_height;
  for (const auto& surface : grid.provenance["mass_flux"]) {
    // The faces of the mesh carry the flux exactly, up to the residuals.
    EXPECT_NEAR(surface["flux"].get<double>() / rate, 1, 1e-4) << surface;
  }
  EXPECT_GT(grid.provenance["grid_flux"].size(), 4u);
  EXPECT_LT(grid.provenance["residuals"]["p"], 1e-5);

  // Before the mesh the series itself; inside it what 16 cells across the neck allow: linear
  // interpolation over a cell of 1/16 is off by 28/8/16^2 = 0.014 in each direction, and most
  // beside the side walls, where the cells of the wide channel are coarser than the layer in which
  // the velocity rises.
  const DuctFlow wide(shape.wide, shape.neck_height), neck(shape.neck_width, shape.neck_height);
  EXPECT_LT(distance(grid, 3, wide, 5e-3), 1e-5);
  EXPECT_LT(distance(grid, plane(grid, -5.5e-4), wide, 5e-3), 0.15);
  const double neck_mean = 5e-3 * shape.wide / shape.neck_width;
  EXPECT_LT(distance(grid, plane(grid, 0.9e-4), neck, neck_mean), 0.1);
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, CoarseFlow,
    testing::Values(Shape{"paper", {}, 1e-4, 1e-4, 4e-4},
                    Shape{"steep", {"geometry.half_angle=90 deg"}, 1e-4, 1e-4, 4e-4},
                    Shape{"gentle", {"geometry.half_angle=20 deg"}, 1e-4, 1e-4, 4e-4},
                    Shape{"high_neck", {"geometry.neck_height=110 um"}, 1e-4, 1.1e-4, 4e-4},
                    Shape{"narrow", {"geometry.channel_width=150 um"}, 1e-4, 1e-4, 1.5e-4}),
    [](const auto& info) { return info.param.name; });

TEST(FlowCase, IsSolvedOnce) {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "case";
  const Scene scene = flow_scene({"flow.mesh_cells_per_neck=8"});
  write_foam_case(scene, folder, foam_template());
  const ShellResult first = solve(folder);
  ASSERT_EQ(first.status, 0) << first.output;
  const auto written = fs::last_write_time(folder / "log.simpleFoam");
  EXPECT_EQ(write_foam_case(scene, folder, foam_template()), FoamCaseState::solved);
  EXPECT_THAT(solve(folder).output, HasSubstr("is already solved here"));
  EXPECT_EQ(fs::last_write_time(folder / "log.simpleFoam"), written);

  // Half of the samples lost: the mapper tells, it does not guess.
  const fs::path samples = foam_samples_file(folder);
  const std::string text = read_text_file(samples);
  write_file(samples, text.substr(0, text.size() / 2));
  EXPECT_THAT(refusal([&] { map_flow(folder); }), HasSubstr("cut short"));
  write_file(samples, text.substr(0, text.rfind('\n', text.size() / 2) + 1));
  EXPECT_THAT(refusal([&] { map_flow(folder); }), HasSubstr("the samples file is incomplete"));
}

TEST(FlowCase, SaysInOneLineWhyItStopped) {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "case";
  write_foam_case(flow_scene({"flow.mesh_cells_per_neck=8"}), folder, foam_template());
  const auto failure = [&](const std::string& message) {
    const ShellResult run = shell("sh '" + (folder / "Allrun").string() + "' > /dev/null");
    EXPECT_EQ(run.status, 1) << message;
    EXPECT_EQ(std::count(run.output.begin(), run.output.end(), '\n'), 1) << run.output;
    EXPECT_THAT(run.output, HasSubstr(message));
    EXPECT_FALSE(fs::exists(folder / "solved"));
  };
  ASSERT_EQ(
      shell("sed -i 's/^endTime .*/endTime 5;/' '" + (folder / "system/controlDict").string() + "'")
          .status,
      0);
  failure("not converged after 5 iterations");
  ASSERT_EQ(shell("sed -i 's/^cellsHigh .*/cellsHigh 0;/' '" +
                  (folder / "system/sceneDict").string() + "'")
                .status,
            0);
  failure("failed; see log.");
  fs::remove(folder / "system/sceneDict");
  failure("write a case: clog case SCENE DIR");
}

}  // namespace
}  // namespace clog
