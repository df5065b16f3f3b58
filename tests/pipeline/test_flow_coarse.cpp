// A flow on a coarse mesh through OpenFOAM and the mapper: laws that hold on any mesh.
#include <algorithm>
#include <cmath>
#include <ostream>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "coupling/base/case_lock.hpp"
#include "coupling/base/text_file.hpp"
#include "coupling/flow/flow_flux.hpp"
#include "coupling/flow/map_flow.hpp"
#include "coupling/geometry/channel_shape.hpp"
#include "coupling/geometry/duct_flow.hpp"
#include "coupling/openfoam/foam_case_writer.hpp"
#include "coupling/openfoam/foam_samples.hpp"
#include "tests/coupling/flow_scene.hpp"
#include "tests/coupling/refusal.hpp"
#include "tests/pipeline/flow_case.hpp"

namespace clogflow {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// Index of the plane of the grid nearest to x.
int plane(const FlowGrid& grid, double x) { return static_cast<int>(std::lround((x - grid.origin.x) / grid.spacing)); }

// Largest difference of the axial velocity in a plane from developed flow, over the mean there.
double distance(const FlowGrid& grid, int i, const DuctFlow& duct, double mean) {
  double worst = 0;
  for (int k = 0; k < grid.points[2]; ++k) {
    for (int j = 0; j < grid.points[1]; ++j) {
      const Vec3 x = grid.origin + grid.spacing * Vec3(i, j, k);
      if (grid.solid[grid.index(i, j, k)]) continue;
      const double u = grid.velocity[3 * grid.index(i, j, k)];
      worst = std::max(worst, std::abs(u / mean - duct(x.y, x.z)));
    }
  }
  return worst;
}

struct Range {
  double smallest, largest;
};

Range axial_velocities(const FlowGrid& grid) {
  Range range{0, 0};
  for (std::size_t i = 0; i < grid.velocity.size(); i += 3) {
    range.smallest = std::min(range.smallest, double{grid.velocity[i]});
    range.largest = std::max(range.largest, double{grid.velocity[i]});
  }
  fmt::print("axial velocity from {:.4g} to {:.4g} m/s\n", range.smallest, range.largest);
  return range;
}

struct Shape {
  const char* name;
  Overrides overrides;
};

void PrintTo(const Shape& shape, std::ostream* out) { *out << shape.name; }

class CoarseFlow : public testing::TestWithParam<Shape> {};

TEST_P(CoarseFlow, ConservesMassAndDevelops) {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "case";
  // The fewest cells with which two meshes are extrapolated.
  Overrides overrides = GetParam().overrides;
  overrides.emplace_back("flow.mesh_cells_per_neck=16");
  const Scene scene = flow_scene(overrides);
  write_foam_case(scene, folder, foam_template());
  const ShellResult run = solve(folder);
  ASSERT_EQ(run.status, 0) << run.output;
  const FlowGrid grid = map_flow(folder);
  check_flow_fits(grid, scene);

  const auto& g = scene.geometry;
  const double rate = 5e-3 * g.channel_width * g.neck_height;
  EXPECT_GT(grid.record.mass_flux->size(), 2u);
  for (const SurfaceFlux& each : *grid.record.mass_flux) {
    // The faces of the mesh carry the flux exactly, up to the residuals.
    EXPECT_NEAR(each.flux / rate, 1, 1e-4) << each.surface;
  }
  EXPECT_TRUE(grid.record.mesh_error->extrapolated);
  EXPECT_GT(grid.record.grid_flux->size(), 4u);
  // Most where the cells are long, behind the inlet of the mesh.
  for (const PlaneFlux& plane : *grid.record.grid_flux) EXPECT_NEAR(plane.error, 0, 0.03) << plane.x;
  EXPECT_LT(grid.record.grid_flux_largest_error.value(), 0.03);
  // The midpoint rule itself misses h^2/24 of the walls' shear, which is the developed pressure gradient: 0.15 to 0.3
  // %. Beside the narrowing the shear is another one. Without the restored flow rate it would be 3 %.
  const double rule = std::pow(grid.spacing, 2) * DuctFlow(g.channel_width, g.neck_height).resistance() / 24;
  for (int i = 0; grid.origin.x + i * grid.spacing <= -narrowing_length(scene.geometry); ++i)
    EXPECT_NEAR(grid_plane(grid, i, scene).error, rule, 0.0015) << i;
  EXPECT_LT(grid.record.residuals->p, 1e-5);

  // Before the mesh the series itself; inside it what 16 and 8 cells across the neck allow, most
  // beside the side walls, where the cells of the wide channel are coarser than the layer in which
  // the velocity rises.
  const DuctFlow wide(g.channel_width, g.neck_height), neck(g.neck_width, g.neck_height);
  EXPECT_LT(distance(grid, 0, wide, 5e-3), 1e-5);
  const double bend = -narrowing_length(scene.geometry);
  EXPECT_LT(distance(grid, plane(grid, bend - 1.15 * g.channel_width), wide, 5e-3), 0.2);
  const double neck_mean = 5e-3 * g.channel_width / g.neck_width;
  EXPECT_LT(distance(grid, plane(grid, neck_start(scene.geometry) + 0.9 * g.neck_width), neck, neck_mean), 0.14);
  // Nowhere faster than the middle of the developed neck, nowhere backwards by more than the error
  // of these meshes in a corner: extrapolation does not overshoot.
  const Range axial = axial_velocities(grid);
  EXPECT_LT(axial.largest / neck_mean, 1.02 * neck(0, g.neck_height / 2));
  EXPECT_GT(axial.smallest / neck_mean, -0.01);
}

const char* longer_neck = "geometry.neck_length=200 um";

INSTANTIATE_TEST_SUITE_P(
    Shapes, CoarseFlow,
    testing::Values(
        Shape{"paper", {}}, Shape{"step", {"geometry.half_angle=90 deg"}},
        Shape{"gentle", {"geometry.half_angle=10 deg"}}, Shape{"high_neck", {"geometry.neck_height=110 um"}},
        Shape{"narrow", {"geometry.channel_width=150 um"}}, Shape{"duct", {"geometry.channel_width=100 um"}},
        Shape{"rounded", {"geometry.neck_rounding=50 um", longer_neck}},
        Shape{"expansion", {"geometry.expansion_width=300 um", longer_neck}},
        Shape{"long_expansion", {"geometry.expansion_width=300 um", "geometry.expansion_length=500 um", longer_neck}},
        Shape{"two_steps", {"geometry.step_width=200 um", "geometry.step_length=150 um"}},
        Shape{"asymmetric", {"geometry.half_angle_below=30 deg"}},
        Shape{"one_sided", {"geometry.half_angle=90 deg", "geometry.half_angle_below=20 deg"}}),
    [](const auto& info) { return info.param.name; });

// The whole width is meshed when the sides differ, here by nothing that matters: the flow is the
// mirror image of itself, and that of the quarter.
TEST(FlowSymmetry, OfTheWholeWidth) {
  const ScratchFolder scratch;
  const auto flow = [&](const char* name, const Overrides& overrides) {
    const fs::path folder = scratch.path() / name;
    write_foam_case(flow_scene(overrides), folder, foam_template());
    EXPECT_EQ(solve(folder).status, 0);
    return map_flow(folder);
  };
  const FlowGrid quarter = flow("quarter", {});
  const FlowGrid whole = flow("whole", {"geometry.half_angle_below=60.0000001 deg"});
  EXPECT_EQ(whole.record.cells.value(), 2 * quarter.record.cells.value());
  double squares = 0, uneven = 0;
  const auto [nx, ny, nz] = whole.points;
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        const std::size_t at = 3 * whole.index(i, j, k), mirror = 3 * whole.index(i, ny - 1 - j, k);
        const auto& u = whole.velocity;
        uneven = std::max({uneven, std::abs(double{u[at]} - u[mirror]), std::abs(double{u[at + 1]} + u[mirror + 1])});
        squares += std::pow(double{u[at]} - quarter.velocity[at], 2);
      }
  // Twenty times the residuals to which both are converged.
  EXPECT_LT(uneven / 20e-3, 2e-4);
  // Gradients and sampling take more neighbours inside a mesh than at the border that the plane of
  // symmetry is for the quarter: on 12 cells this is 0.26 % of the pressure drop.
  EXPECT_LT(std::sqrt(squares / static_cast<double>(whole.solid.size())) / 20e-3, 0.005);
  EXPECT_NEAR(whole.record.pressure_drop.value() / quarter.record.pressure_drop.value(), 1, 0.005);
}

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
  ASSERT_EQ(shell("sed -i 's/^endTime .*/endTime 5;/' '" + (folder / "system/controlDict").string() + "'").status, 0);
  failure("not converged after 5 iterations");
  ASSERT_EQ(shell("sed -i 's/^vertices/nothing/' '" + (folder / "system/blockMeshDict").string() + "'").status, 0);
  failure(
      "blockMesh (OpenFOAM 1912; this case is tested with 1912) stopped with status 1: Entry "
      "'vertices' not found");
  fs::remove(folder / "system/sceneDict");
  failure("write a case: clog case SCENE DIR");
}

/// A program of OpenFOAM of the test's own, before all others in PATH.
std::string with_program(const fs::path& bin, const std::string& name, const std::string& lines) {
  write_file(bin / name, "#!/bin/sh\n" + lines);
  fs::permissions(bin / name, fs::perms::owner_all);
  return "PATH='" + bin.string() + "':\"$PATH\" ";
}

TEST(FlowCase, NamesTheProgramThatFailedItsVersionAndItsWords) {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "case", bin = scratch.path() / "bin";
  write_foam_case(flow_scene({"flow.mesh_cells_per_neck=8"}), folder, foam_template());
  const auto said_with = [&](const std::string& lines) {
    const ShellResult run =
        shell(with_program(bin, "simpleFoam", lines) + "sh '" + (folder / "Allrun").string() + "' > /dev/null");
    EXPECT_EQ(run.status, 1);
    return run.output;
  };
  EXPECT_THAT(said_with("echo 'simpleFoam: error while loading shared libraries: libX.so: cannot open' "
                        ">&2; exit 127"),
              testing::AllOf(HasSubstr("bin/simpleFoam (OpenFOAM of unknown version; this case is tested with 1912) "
                                       "could not "
                                       "be started: simpleFoam: error while loading shared libraries: libX.so"),
                             testing::Not(HasSubstr("diverged"))));
  EXPECT_THAT(said_with("echo '|  \\\\  /  O peration  | Version:  9     |'; printf -- '\\n--> "
                        "FOAM FATAL IO ERROR: \\nkeyword div is "
                        "undefined\\n'; exit 1"),
              HasSubstr("(OpenFOAM 9; this case is tested with 1912) stopped with status 1: "
                        "keyword div is undefined; see log"));
  EXPECT_THAT(said_with("echo 'Time = 1'; echo 'Time = 2'; kill -8 $$"),
              HasSubstr("was ended by signal 8 after 2 iterations (the solution diverged?)"));
}

TEST(FlowCase, TwoAllrunAtOnceSolveItOnce) {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "case";
  write_foam_case(flow_scene({"flow.mesh_cells_per_neck=8"}), folder, foam_template());
  const std::string run = "sh '" + (folder / "Allrun").string() + "'";
  const ShellResult both = shell(run + " & first=$!; while [ ! -s '" + (folder / "lock").string() +
                                 "' ]; do sleep 0.05; done; " + run + " && wait $first");
  EXPECT_EQ(both.status, 0) << both.output;
  EXPECT_THAT(both.output, testing::AllOf(HasSubstr("waits for process "), HasSubstr("is already solved here")));
  EXPECT_EQ(both.output.find("  simpleFoam"), both.output.rfind("  simpleFoam")) << both.output;
}

TEST(FlowCase, WaitsNotForEver) {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "case";
  write_foam_case(flow_scene({"flow.mesh_cells_per_neck=8"}), folder, foam_template());
  CaseLock other(folder);
  ASSERT_TRUE(other.take());
  write_file(folder / "lock", "process 17 on node\n");
  const ShellResult run = shell("CLOG_LONGEST_WAIT=1 sh '" + (folder / "Allrun").string() + "'");
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.output, HasSubstr("process 17 on node is still at work here after 1 s; call again"));
}

TEST(FlowCase, IsNotSolvedBeforeItIsWritten) {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "case";
  write_foam_case(flow_scene({"flow.mesh_cells_per_neck=8"}), folder, foam_template());
  write_file(folder / "hash", "unfinished\n");
  const ShellResult run = solve(folder);
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.output, HasSubstr("clog case did not finish writing this case; call it again"));
}

}  // namespace
}  // namespace clogflow
