// The error estimate of `clog case --check` against a solution on a much finer mesh.
#include <cmath>

#include <gmock/gmock.h>

#include "coupling/flow/flow_error.hpp"
#include "coupling/flow/map_flow.hpp"
#include "coupling/openfoam/flow_mesh.hpp"
#include "coupling/openfoam/foam_case_writer.hpp"
#include "coupling/openfoam/foam_log.hpp"
#include "tests/coupling/flow_scene.hpp"
#include "tests/coupling/refusal.hpp"
#include "tests/pipeline/flow_case.hpp"

namespace clogflow {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

double rms_difference(const FoamSamples& a, const FoamSamples& b) {
  double squares = 0, count = 0;
  for (std::size_t i = 0; i < a.velocity.size(); ++i) {
    if (!a.found[i] || !b.found[i]) continue;
    ++count;
    for (int c = 0; c < 3; ++c) squares += std::pow(double{a.velocity[i][c]} - double{b.velocity[i][c]}, 2);
  }
  return std::sqrt(squares / count);
}

class FlowError : public testing::TestWithParam<const char*> {};

TEST_P(FlowError, IsHonest) {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "case", finer = scratch.path() / "finer";
  const std::string angle = std::string("geometry.half_angle=") + GetParam();
  const char* cells = "flow.mesh_cells_per_neck=16";
  const Scene scene = flow_scene({angle, cells, "flow.extrapolate=false"});
  write_foam_case(scene, folder, foam_template(), FoamCaseCheck::with_coarser_mesh);
  EXPECT_THAT(refusal([&] { read_coarser_flow(folder, scene); }), HasSubstr("coarse is not solved"));
  write_foam_case(flow_scene({angle, "flow.mesh_cells_per_neck=32", "flow.extrapolate=false"}), finer, foam_template());
  const ShellResult run = solve(folder), finer_run = solve(finer);
  ASSERT_EQ(run.status, 0) << run.output;
  ASSERT_EQ(finer_run.status, 0) << finer_run.output;

  const FlowGrid grid = map_flow(folder);
  const FlowLattice lattice = flow_lattice(scene, flow_mesh(scene));
  const auto read = [&](const fs::path& from) { return read_foam_samples(foam_samples_file(from), lattice); };
  const double neck_mean = 20e-3;
  const double velocity = rms_difference(read(folder), read(finer)) / neck_mean;
  const double pressure = std::abs(read_pressure_drop(folder) / read_pressure_drop(finer) - 1);
  const MeshError& told = grid.record.mesh_error.value();
  // The finer mesh has an error of its own, a third of this one's.
  EXPECT_GT(told.velocity_rms, velocity);
  EXPECT_LT(told.velocity_rms, 2.5 * velocity);
  EXPECT_GT(told.pressure_drop, pressure);
  EXPECT_LT(told.pressure_drop, 5 * pressure + 1e-3);
  EXPECT_GT(told.velocity_largest, told.velocity_99_percent);

  // What the two meshes together say is nearer to the finer solution than the wanted one is, and
  // what is told for it is not below its own difference.
  FoamSamples better = read(folder);
  const VelocityError added = extrapolate(better, read_coarser_flow(folder, scene)->samples, neck_mean);
  const double left = rms_difference(better, read(finer)) / neck_mean;
  // Not by much: the finer mesh is not extrapolated, and its own error stays in the difference.
  EXPECT_LT(left, velocity);
  EXPECT_GT(added.rms, left);
  EXPECT_FALSE(told.extrapolated);

  const Scene other = flow_scene({angle, cells, "flow.extrapolate=false", "fluid.viscosity=1 mPa s"});
  EXPECT_THAT(refusal([&] { read_coarser_flow(folder, other); }), HasSubstr("is not the coarser case of"));
}

TEST(FlowExtrapolation, NeedsTheCoarserCase) {
  const ScratchFolder scratch;
  EXPECT_THAT(refusal([&] { read_coarser_flow(scratch.path(), flow_scene({"flow.extrapolate=true"})); }),
              HasSubstr("coarse is missing (flow.extrapolate = true needs the coarser case)"));
}

INSTANTIATE_TEST_SUITE_P(Angles, FlowError, testing::Values("\"30 deg\"", "\"90 deg\""));

}  // namespace
}  // namespace clogflow
