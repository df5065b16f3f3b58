#include "coupling/openfoam/foam_log.hpp"

#include <gmock/gmock.h>

#include "coupling/base/text_file.hpp"
#include "coupling/flow/map_flow.hpp"
#include "coupling/openfoam/foam_case_writer.hpp"
#include "tests/coupling/flow_scene.hpp"
#include "tests/coupling/refusal.hpp"

namespace clogflow {
namespace {

using testing::HasSubstr;

constexpr const char* solver_log =
    "| \\\\  /  | Version:  v2312\n"
    "smoothSolver:  Solving for Ux, Initial residual = 0.5, Final residual = 1e-3, No Iterations "
    "1\n"
    "smoothSolver:  Solving for Ux, Initial residual = 5.1e-06, Final residual = 1e-8, No "
    "Iterations 1\n"
    "smoothSolver:  Solving for Uy, Initial residual = 6.7e-06, Final residual = 1e-8, No "
    "Iterations 1\n"
    "smoothSolver:  Solving for Uz, Initial residual = 9.9e-06, Final residual = 1e-8, No "
    "Iterations 1\n"
    "GAMG:  Solving for p, Initial residual = 7.7e-06, Final residual = 1e-8, No Iterations 1\n"
    "SIMPLE solution converged in 164 iterations\n";

void write_logs(const std::filesystem::path& folder) {
  write_file(folder / "log.simpleFoam", solver_log);
  write_file(folder / "log.checkMesh",
             "Mesh stats\n    cells:            46560\n"
             "    Mesh non-orthogonality Max: 29.5 average: 10.8\nMesh OK.\n");
  write_file(folder / "fluxes", "inlet 5e-11\noutlet 5.0001e-11\n");
}

TEST(FoamLog, TellsHowTheFlowWasSolved) {
  const ScratchFolder scratch;
  write_logs(scratch.path());
  const auto found = read_foam_logs(scratch.path(), 4);
  EXPECT_EQ(found.openfoam_version, "v2312");
  EXPECT_EQ(found.iterations, 164);
  EXPECT_EQ(found.cells, 46560);
  EXPECT_DOUBLE_EQ(found.residuals->ux, 5.1e-6);
  EXPECT_NEAR(found.mass_flux->at(1).flux, 2.00004e-10, 1e-20);
  EXPECT_NEAR(found.mass_flux->at(1).error, 2e-5, 1e-12);
}

TEST(FoamLog, RefusesLogsThatAreCutShort) {
  const ScratchFolder scratch;
  const auto read = [&] { return refusal([&] { read_foam_logs(scratch.path(), 4); }); };
  EXPECT_THAT(read(), HasSubstr("log.simpleFoam is missing"));
  write_logs(scratch.path());
  write_file(scratch.path() / "log.simpleFoam", "Time = 3\n");
  EXPECT_THAT(read(), HasSubstr("holds no \"SIMPLE solution converged in\" (cut short?)"));
  write_logs(scratch.path());
  write_file(scratch.path() / "fluxes", "inlet 0\noutlet 1\n");
  EXPECT_THAT(read(), HasSubstr("one positive flux a surface"));
}

TEST(FoamLog, ReadsThePressureDrop) {
  const ScratchFolder scratch;
  write_file(scratch.path() / "pressure", "0.0167\n");
  EXPECT_DOUBLE_EQ(read_pressure_drop(scratch.path()), 0.0167);
  write_file(scratch.path() / "pressure", "\n");
  EXPECT_THAT(refusal([&] { read_pressure_drop(scratch.path()); }),
              HasSubstr("pressure holds no positive number; run the case's Allrun again"));
}

TEST(MapFlow, RefusesCasesThatAreNotSolvedOrOfOtherInputs) {
  const ScratchFolder scratch;
  const auto folder = scratch.path() / "case";
  const auto map = [&] { return refusal([&] { map_flow(folder); }); };
  EXPECT_THAT(map(), HasSubstr("is missing (expected the folder of a flow case)"));
  write_foam_case(flow_scene(), folder, foam_template());
  EXPECT_THAT(map(), HasSubstr("is not solved; run " + (folder / "Allrun").string()));
  write_file(folder / "solved", "0123456789abcdef\n");
  EXPECT_THAT(map(), HasSubstr("holds the flow of other inputs (0123456789abcdef"));
  write_file(folder / "solved", read_text_file(folder / "hash"));
  EXPECT_THAT(map(), HasSubstr("lattice_U.xy is missing"));
  write_file(folder / "scene.toml", effective_scene(flow_scene({"flow.mean_velocity=1 mm/s"})));
  EXPECT_THAT(map(), HasSubstr("does not describe the flow"));
}

}  // namespace
}  // namespace clogflow
