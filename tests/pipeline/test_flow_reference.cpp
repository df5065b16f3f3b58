// The default mesh and grid against the reference solution of the 60 degree constriction.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "coupling/base/source_folder.hpp"
#include "coupling/base/text_file.hpp"
#include "coupling/flow/flow_error.hpp"
#include "coupling/flow/map_flow.hpp"
#include "coupling/geometry/stl_channel.hpp"
#include "coupling/openfoam/coarser_case.hpp"
#include "coupling/openfoam/foam_case_writer.hpp"
#include "dem/fluid/flow_field.hpp"
#include "tests/coupling/flow_scene.hpp"
#include "tests/pipeline/flow_case.hpp"
#include "tests/test_data.hpp"

namespace clogflow {
namespace {

namespace fs = std::filesystem;

constexpr double neck_width = 1e-4;  // [m]
constexpr double neck_mean = 20e-3;  // [m/s]
constexpr double density = 1062;     // [kg/m3]

struct ReferencePoint {
  Vec3 place, stokes, velocity;  // [m], [m/s]; creeping flow, Navier-Stokes
};

std::vector<ReferencePoint> reference_points() {
  std::ifstream in(test_data("flow_60deg.csv"));
  std::vector<ReferencePoint> points;
  std::string line;
  while (std::getline(in, line)) {
    if (line.empty() || line[0] == '#' || line[0] == 'x') continue;
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream numbers(line);
    double value[9];
    for (double& v : value) numbers >> v;
    points.push_back({.place = neck_width * Vec3(value[0], value[1], value[2]),
                      .stokes = {value[3], value[4], value[5]},
                      .velocity = {value[6], value[7], value[8]}});
  }
  return points;
}

struct Deviation {
  double rms = 0, largest = 0;  // of the neck's mean velocity
};

// Deviation of a field from the reference; velocity(i) is the field at its point i.
template <class Velocity>
Deviation deviation(const std::vector<ReferencePoint>& points, Vec3 ReferencePoint::*wanted, const Velocity& velocity) {
  Deviation result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double error = (velocity(i) - points[i].*wanted).norm() / neck_mean;
    result.rms += error * error / static_cast<double>(points.size());
    result.largest = std::max(result.largest, error);
  }
  result.rms = std::sqrt(result.rms);
  fmt::print("rms {:.3f} %, largest {:.3f} % of the neck mean\n", 100 * result.rms, 100 * result.largest);
  return result;
}

Vec3 quarter(const Vec3& x) { return {x.x, std::abs(x.y), std::min(x.z, neck_width - x.z)}; }

// Values of a field of a case at points of the quarter, by OpenFOAM's own interpolation.
std::vector<std::vector<double>> sampled(const fs::path& folder, const std::string& field,
                                         const std::vector<Vec3>& places) {
  std::string list;
  for (const Vec3& x : places) list += fmt::format("({} {} {})\n", x.x, x.y, x.z);
  write_file(folder / "system" / "checkDict",
             "FoamFile { version 2.0; format ascii; class dictionary; object checkDict; }\n"
             "functions { check { type sets; libs (sampling); setFormat raw; fields (" +
                 field +
                 "); interpolationScheme cellPointFace; sets ( points { type cloud; axis xyz; "
                 "points (\n" +
                 list + "); } ); } }\n");
  const ShellResult post = shell("cd '" + folder.string() +
                                 "' && WM_PROJECT_DIR=${WM_PROJECT_DIR:-/usr/share/openfoam} "
                                 "postProcess -latestTime -dict system/checkDict -fields '(" +
                                 field + ")'" + " && mv postProcessing/check/*/points_" + field + ".xy check_" + field);
  EXPECT_EQ(post.status, 0) << post.output;
  std::istringstream in(read_text_file(folder / ("check_" + field)));
  std::vector<std::vector<double>> rows;
  for (std::string line; std::getline(in, line);) {
    std::istringstream numbers(line);
    rows.emplace_back(std::istream_iterator<double>(numbers), std::istream_iterator<double>());
  }
  return rows;
}

// From x = -3 D to 0.9 D on one mesh [Pa].
double pressure_drop(const fs::path& folder) {
  const auto rows = sampled(folder, "p", {{-3e-4, 1e-6, 4.9e-5}, {0.9e-4, 1e-6, 4.9e-5}});
  EXPECT_EQ(rows.size(), 2u);
  return density * (rows.at(0).at(3) - rows.at(1).at(3));
}

// The same from both meshes of a case.
double extrapolated_drop(const fs::path& folder) {
  const double fine = pressure_drop(folder);
  const double drop = fine + correction(fine, pressure_drop(coarser_folder(folder)));
  fmt::print("pressure drop {:.6g} Pa on the mesh, {:.6g} Pa extrapolated\n", fine, drop);
  return drop;
}

Deviation through_grid(const FlowGrid& grid, Lookup lookup, Vec3 ReferencePoint::*wanted, double scale) {
  const auto points = reference_points();
  const FlowField field(grid, lookup);
  return deviation(points, wanted, [&](std::size_t i) -> Vec3 {
    const Vec3& x = points[i].place;
    const auto u = field.at(x.x, x.y, x.z);
    return scale * Vec3(u[0], u[1], u[2]);
  });
}

// One solution for all tests of this program.
class FlowReference : public testing::Test {
protected:
  static void SetUpTestSuite() {
    scratch = new ScratchFolder;
    folder = scratch->path() / "case";
    const Scene scene = read_scene(source_folder() / "scenes" / "paper.toml");
    write_foam_case(scene, folder, foam_template());
    run = solve(folder);
  }
  static void TearDownTestSuite() { delete scratch; }
  void SetUp() override { ASSERT_EQ(run.status, 0) << run.output; }

  inline static ScratchFolder* scratch = nullptr;
  inline static fs::path folder;
  inline static ShellResult run{-1, ""};
};

TEST_F(FlowReference, VelocityOfOpenFoamItself) {
  const auto points = reference_points();
  ASSERT_EQ(points.size(), 400u);
  std::vector<Vec3> places;
  for (const auto& point : points) places.push_back(quarter(point.place));
  const auto rows = sampled(folder, "U", places);
  ASSERT_EQ(rows.size(), points.size());
  const Deviation d = deviation(points, &ReferencePoint::velocity, [&](std::size_t i) {
    const Vec3& x = points[i].place;
    return Vec3(rows[i].at(3), std::copysign(1.0, x.y) * rows[i].at(4),
                (x.z > neck_width / 2 ? -1 : 1) * rows[i].at(5));
  });
  EXPECT_LT(d.rms, 0.002);
  EXPECT_LT(d.largest, 0.02);
}

TEST_F(FlowReference, VelocityThroughTheGrid) {
  const FlowGrid grid = map_flow(folder);
  const Deviation smooth = through_grid(grid, Lookup::trilinear, &ReferencePoint::velocity, 1);
  EXPECT_LT(smooth.rms, 0.00092);
  EXPECT_LT(smooth.largest, 0.02);
  // Every plane, those between long cells included, which waver by 2 % before their flow rate is
  // restored.
  EXPECT_GT(grid.record.flow_rate_restored.value(), 0.01);
  EXPECT_LT(grid.record.grid_flux_largest_error.value(), 0.003);
  // What is told is not below the error.
  const MeshError& told = grid.record.mesh_error.value();
  EXPECT_TRUE(told.extrapolated);
  EXPECT_GT(told.velocity_rms, smooth.rms);
  EXPECT_GT(told.velocity_largest, smooth.largest);
  // The nearest point is up to half a spacing away: half of 2 um times 6 to 8 neck means per neck
  // width.
  const Deviation nearest = through_grid(grid, Lookup::nearest, &ReferencePoint::velocity, 1);
  EXPECT_LT(nearest.rms, 0.025);
  EXPECT_LT(nearest.largest, 0.1);
}

TEST_F(FlowReference, PressureDrop) { EXPECT_NEAR(extrapolated_drop(folder), 17.72, 0.01 * 17.72); }

// The same channel from a file, on cells three times as large.
TEST(StlReference, IsWithinWhatIsTold) {
  const ScratchFolder scratch;
  const Scene keys = read_scene(source_folder() / "scenes" / "paper.toml",
                                {"geometry.channel_length=700 um", "geometry.neck_length=200 um"});
  write_file(scratch.path() / "walls.stl", channel_stl(keys.geometry, 1e-6));
  const std::string text = effective_scene(keys);
  write_file(scratch.path() / "scene.toml",
             "[geometry]\nstl = \"walls.stl\"\nstl_unit = \"1 um\"\nneck_width = \"100 um\"\n\n" +
                 text.substr(text.find("[fluid]")));
  const fs::path folder = scratch.path() / "case";
  write_foam_case(read_scene(scratch.path() / "scene.toml",
                             {"flow.mesh_cells_per_neck=16", "flow.grid_spacing=4 um", "flow.extrapolate=true"}),
                  folder, foam_template());
  const ShellResult run = solve(folder);
  ASSERT_EQ(run.status, 0) << run.output;
  const FlowGrid grid = map_flow(folder);
  const Deviation smooth = through_grid(grid, Lookup::trilinear, &ReferencePoint::velocity, 1);
  EXPECT_LT(smooth.rms, 0.006);
  const MeshError& told = grid.record.mesh_error.value();
  EXPECT_TRUE(told.extrapolated);
  EXPECT_GT(told.velocity_rms, smooth.rms);
  EXPECT_LT(told.velocity_rms, 3 * smooth.rms);
}

// A thousandth of the flow rate is creeping flow (Reynolds number 1.2e-3 in the neck): everything
// is a thousandth of the Stokes solution. Half the cells keep this cheap.
TEST(CreepingFlow, IsTheStokesSolution) {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "case";
  write_foam_case(read_scene(source_folder() / "scenes" / "paper.toml",
                             {"flow.mean_velocity=5 um/s", "flow.mesh_cells_per_neck=24", "flow.grid_spacing=4 um"}),
                  folder, foam_template());
  const ShellResult run = solve(folder);
  ASSERT_EQ(run.status, 0) << run.output;
  EXPECT_NEAR(1000 * extrapolated_drop(folder), 17.28, 0.01 * 17.28);
  const Deviation smooth = through_grid(map_flow(folder), Lookup::trilinear, &ReferencePoint::stokes, 1000);
  EXPECT_LT(smooth.rms, 0.005);
  // Inertia alone would be 3.3 %.
  EXPECT_LT(smooth.largest, 0.02);
}

}  // namespace
}  // namespace clogflow
