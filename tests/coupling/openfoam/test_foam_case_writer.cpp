#include "coupling/openfoam/foam_case_writer.hpp"

#include <signal.h>
#include <sys/resource.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <string>

#include <gmock/gmock.h>

#include "coupling/base/case_lock.hpp"
#include "coupling/base/content_hash.hpp"
#include "coupling/base/text_file.hpp"
#include "coupling/openfoam/flow_lattice.hpp"
#include "coupling/openfoam/flow_mesh.hpp"
#include "coupling/openfoam/foam_dictionaries.hpp"
#include "tests/coupling/flow_scene.hpp"
#include "tests/coupling/refusal.hpp"

namespace clogflow {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::string hash_of(const Overrides& overrides) { return content_hash(flow_inputs(flow_scene(overrides))); }

TEST(FoamCaseWriter, WritesAWholeCase) {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "case";
  EXPECT_EQ(write_foam_case(flow_scene(), folder, foam_template()), FoamCaseState::written);
  for (const char* name : {"Allrun", "Allclean", "hash", "scene.toml", "0.orig/U", "0.orig/p", "constant/inletProfile",
                           "constant/transportProperties", "constant/turbulenceProperties", "system/sceneDict",
                           "system/blockMeshDict", "system/controlDict", "system/fvSchemes", "system/fvSolution",
                           "system/topoSetDict", "system/fluxDict", "surfaces", "system/postProcessDict"}) {
    EXPECT_TRUE(fs::is_regular_file(folder / name)) << name;
  }
  EXPECT_TRUE(read_text_file(folder / "hash").starts_with(hash_of({}) + "\n"));
  EXPECT_EQ(effective_scene(parse_scene(read_text_file(folder / "scene.toml"), "scene.toml")),
            effective_scene(flow_scene()));
  EXPECT_NE(fs::status(folder / "Allrun").permissions() & fs::perms::owner_exec, fs::perms::none);
}

TEST(FoamCaseWriter, KeepsASolvedFlowAndReplacesAnotherOne) {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "case";
  write_foam_case(flow_scene(), folder, foam_template());
  EXPECT_EQ(write_foam_case(flow_scene(), folder, foam_template()), FoamCaseState::unsolved);
  write_file(folder / "solved", read_text_file(folder / "hash"));
  write_file(folder / "164" / "U", "result");
  write_file(folder / "log.simpleFoam", "log");
  EXPECT_EQ(write_foam_case(flow_scene({"particles.diameter=50 um"}), folder, foam_template()), FoamCaseState::solved);
  EXPECT_TRUE(fs::exists(folder / "164" / "U"));
  EXPECT_EQ(write_foam_case(flow_scene({"flow.mean_velocity=1 mm/s"}), folder, foam_template()),
            FoamCaseState::written);
  EXPECT_FALSE(fs::exists(folder / "164"));
  EXPECT_FALSE(fs::exists(folder / "solved"));
  EXPECT_FALSE(fs::exists(folder / "log.simpleFoam"));
  EXPECT_TRUE(fs::exists(folder / "0.orig" / "U"));
}

/// As on a full disk: no file grows over a kilobyte.
std::string refusal_without_room(const std::function<void()>& work) {
  signal(SIGXFSZ, SIG_IGN);
  rlimit old{};
  getrlimit(RLIMIT_FSIZE, &old);
  const rlimit small{.rlim_cur = 1000, .rlim_max = old.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string said = refusal(work);
  setrlimit(RLIMIT_FSIZE, &old);
  return said;
}

TEST(FoamCaseWriter, WhatAFailedCallLeftNeitherPassesForSolvedNorBlocksTheNext) {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "case";
  const auto write = [&](const char* speed) {
    return write_foam_case(flow_scene({std::string("flow.mean_velocity=") + speed}), folder, foam_template());
  };
  EXPECT_THAT(refusal_without_room([&] { write("5 mm/s"); }), HasSubstr("cannot be written: File too large"));
  EXPECT_EQ(read_text_file(folder / "hash"), "unfinished\n");
  EXPECT_EQ(write("5 mm/s"), FoamCaseState::written);
  write_file(folder / "solved", read_text_file(folder / "hash"));
  EXPECT_THAT(refusal_without_room([&] { write("1 mm/s"); }), HasSubstr("cannot be written: File too large"));
  EXPECT_FALSE(fs::exists(folder / "solved"));
  EXPECT_EQ(read_text_file(folder / "hash"), "unfinished\n");
  EXPECT_EQ(write("5 mm/s"), FoamCaseState::written);
  // Killed in its first moments.
  fs::remove_all(folder);
  fs::create_directories(folder);
  write_file(folder / "lock", "");
  write_file(folder / "hash.clog.part", "unfi");
  EXPECT_EQ(write("5 mm/s"), FoamCaseState::written);
}

TEST(FoamCaseWriter, AReadOnlyInstallationMakesAWritableCase) {
  const ScratchFolder scratch;
  const fs::path own = scratch.path() / "template", folder = scratch.path() / "case";
  fs::copy(foam_template(), own, fs::copy_options::recursive);
  const auto writable = fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
  for (const auto& entry : fs::recursive_directory_iterator(own))
    fs::permissions(entry.path(), writable, fs::perm_options::remove);
  write_foam_case(flow_scene(), folder, own);
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    EXPECT_NE(fs::status(entry.path()).permissions() & fs::perms::owner_write, fs::perms::none) << entry.path();
}

TEST(FoamCaseWriter, LeavesACaseAloneThatIsBeingSolved) {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "case";
  write_foam_case(flow_scene(), folder, foam_template());
  write_file(folder / "log.simpleFoam", "half");
  CaseLock solver(folder);
  ASSERT_TRUE(solver.take());
  write_file(folder / "lock", "process 17 on node\n");
  EXPECT_EQ(write_foam_case(flow_scene(), folder, foam_template()), FoamCaseState::unsolved);
  EXPECT_THAT(refusal([&] { write_foam_case(flow_scene({"flow.mean_velocity=1 mm/s"}), folder, foam_template()); }),
              HasSubstr("is being solved for another flow, by process 17 on node; wait for it"));
  EXPECT_EQ(read_text_file(folder / "log.simpleFoam"), "half");
}

TEST(FoamCaseWriter, AChangedTemplateIsAnotherCase) {
  const ScratchFolder scratch;
  const fs::path own = scratch.path() / "template", folder = scratch.path() / "case";
  fs::copy(foam_template(), own, fs::copy_options::recursive);
  write_foam_case(flow_scene(), folder, own);
  write_file(folder / "solved", read_text_file(folder / "hash"));
  EXPECT_EQ(write_foam_case(flow_scene(), folder, own), FoamCaseState::solved);
  write_file(own / "system" / "fvSchemes", read_text_file(own / "system" / "fvSchemes") + "// other\n");
  EXPECT_EQ(write_foam_case(flow_scene(), folder, own), FoamCaseState::written);
  EXPECT_FALSE(fs::exists(folder / "solved"));
}

TEST(FoamCaseWriter, ACheckAddsACoarserCase) {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "case";
  const auto write = [&](FoamCaseCheck check) { return write_foam_case(flow_scene(), folder, foam_template(), check); };
  EXPECT_EQ(write(FoamCaseCheck::with_coarser_mesh), FoamCaseState::written);
  const fs::path coarse = folder / "coarse";
  EXPECT_EQ(parse_scene(read_text_file(coarse / "scene.toml"), "").flow.mesh_cells_per_neck, 6);
  write_file(folder / "solved", read_text_file(folder / "hash"));
  EXPECT_EQ(write(FoamCaseCheck::with_coarser_mesh), FoamCaseState::unsolved);
  EXPECT_EQ(write(FoamCaseCheck::without), FoamCaseState::solved);
  EXPECT_THAT(refusal([&] {
                write_foam_case(flow_scene({"flow.mesh_cells_per_neck=7"}), folder, foam_template(),
                                FoamCaseCheck::with_coarser_mesh);
              }),
              HasSubstr("flow.mesh_cells_per_neck = 7 (a check solves with half of them"));
}

TEST(FoamCaseWriter, AnExtrapolatedFlowHasACoarserCase) {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "case";
  write_foam_case(flow_scene({"flow.extrapolate=true"}), folder, foam_template());
  const Scene coarse = parse_scene(read_text_file(folder / "coarse" / "scene.toml"), "");
  EXPECT_EQ(coarse.flow.mesh_cells_per_neck, 6);
  EXPECT_FALSE(coarse.flow.extrapolate);
}

TEST(FoamCaseWriter, OnlyKeysOfTheFlowChangeTheHash) {
  const std::string hash = hash_of({});
  for (const char* key : {"particles.diameter=50 um", "contact.youngs_modulus=1 GPa", "ensemble.seeds=1-9",
                          "geometry.channel_length=2 mm"}) {
    EXPECT_EQ(hash_of({key}), hash) << key;
  }
  for (const char* key : {"geometry.neck_width=90 um", "geometry.neck_height=110 um", "geometry.channel_width=500 um",
                          "geometry.channel_length=300 um", "geometry.neck_length=150 um", "geometry.half_angle=45 deg",
                          "flow.mean_velocity=4 mm/s", "fluid.viscosity=1e-3 Pa s", "fluid.density=1000 kg/m3",
                          "flow.mesh_cells_per_neck=20", "flow.extrapolate=true"}) {
    EXPECT_NE(hash_of({key}), hash) << key;
  }
}

TEST(FoamCaseWriter, RefusesAFolderWithOtherThings) {
  const ScratchFolder scratch;
  write_file(scratch.path() / "thesis.tex", "precious");
  EXPECT_THAT(refusal([&] { write_foam_case(flow_scene(), scratch.path(), foam_template()); }),
              HasSubstr("is not empty and not a flow case"));
  EXPECT_THAT(refusal([&] { write_foam_case(flow_scene(), scratch.path() / "thesis.tex", foam_template()); }),
              HasSubstr("is a file (a case needs a folder)"));
}

TEST(FoamCaseWriter, RefusesScenesWithoutSuchAFlow) {
  const ScratchFolder scratch;
  const auto write = [&](const Overrides& overrides) {
    return refusal([&] { write_foam_case(flow_scene(overrides), scratch.path() / "case", foam_template()); });
  };
  EXPECT_THAT(write({"flow.source=none"}), HasSubstr("flow.source is not \"openfoam\""));
  EXPECT_THAT(write({"flow.grid_spacing=7 um"}), HasSubstr("it must divide geometry.neck_height"));
  EXPECT_FALSE(fs::exists(scratch.path() / "case")) << "refused before anything is written";
}

// The arc at a corner leaves the wall at half the angle between the walls there: for 60 degrees its
// tangent is turned by 30, and the axis point lies half_width tan(15 deg) before the corner.
TEST(FlowMesh, ArcsHalveTheCorners) {
  const FlowMesh mesh = flow_mesh(flow_scene());
  const MeshStation &wide = mesh.stations.at(1), &edge = mesh.stations.at(2);
  EXPECT_EQ(wide.name, "wideCorner");
  EXPECT_EQ(edge.name, "neckEdge");
  EXPECT_TRUE(edge.edge && !wide.edge);
  EXPECT_NEAR(edge.axis, -0.5e-4 * 0.26794919, 1e-12);
  EXPECT_NEAR(wide.foot[0].wall.x(), -0.8660254e-4, 1e-12);
  EXPECT_NEAR(wide.axis, wide.foot[0].wall.x() - 2e-4 * 0.26794919, 1e-11);
}

TEST(FlowMesh, IsMadeForEveryShape) {
  for (const char* angle : {"10 deg", "30 deg", "60 deg", "90 deg"}) {
    for (const char* width : {"120 um", "400 um", "1 mm"}) {
      const FlowMesh mesh = flow_mesh(
          flow_scene({std::string("geometry.half_angle=") + angle, std::string("geometry.channel_width=") + width}));
      EXPECT_LT(mesh.inlet(), mesh.outlet());
      for (const MeshBlock& block : mesh.blocks) {
        EXPECT_GE(block.cells, 2) << angle << " " << width;
        EXPECT_LE(block.cells, 400) << angle << " " << width;
        EXPECT_TRUE(std::isfinite(block.wall_grading[0]) && block.wall_grading[0] > 0);
      }
    }
  }
}

TEST(FlowMesh, RefusesCurvesThatCross) {
  EXPECT_THAT(refusal([] {
                flow_mesh(flow_scene({"geometry.half_angle=90 deg", "geometry.half_angle_below=10 deg",
                                      "geometry.channel_width=130 um", "geometry.neck_rounding=10 um"}));
              }),
              HasSubstr("this shape cannot be meshed: the curves across the channel at"));
}

TEST(FlowMesh, GradedEdgesFollowTheRatio) {
  EXPECT_DOUBLE_EQ(graded_edge(0, 8, 0.25), 0);
  EXPECT_DOUBLE_EQ(graded_edge(8, 8, 0.25), 1);
  const double first = graded_edge(1, 8, 0.25), last = 1 - graded_edge(7, 8, 0.25);
  EXPECT_NEAR(last / first, 0.25, 1e-12);
}

TEST(FoamDictionaries, InletFacesCarryTheWholeFlux) {
  const Scene scene = flow_scene();
  const FlowMesh mesh = flow_mesh(scene);
  std::string text = inlet_profile(scene, mesh);
  for (char& c : text) {
    if (c == '(' || c == ')') c = ' ';
  }
  std::istringstream in(text.substr(text.find('\n', text.find("<vector>"))));
  double flux = 0;
  for (int k = 0; k < mesh.cells_high; ++k) {
    for (int j = 0; j < mesh.cells_across; ++j) {
      double u = 0, v = 0, w = 0;
      in >> u >> v >> w;
      flux += u *
              (graded_edge(j + 1, mesh.cells_across, mesh.stations[0].grading) -
               graded_edge(j, mesh.cells_across, mesh.stations[0].grading)) *
              (graded_edge(k + 1, mesh.cells_high, height_grading) - graded_edge(k, mesh.cells_high, height_grading));
    }
  }
  EXPECT_NEAR(flux / scene.flow.mean_velocity, 1, 1e-6);
}

TEST(FlowLattice, CoversTheChannelAndAvoidsTheWalls) {
  const Scene scene = flow_scene();
  const FlowLattice lattice = flow_lattice(scene, flow_mesh(scene));
  EXPECT_EQ(lattice.height, 20);
  EXPECT_EQ(lattice.half_width, 40);
  EXPECT_LE(lattice.coordinate(lattice.x_begin), flow_mesh(scene).inlet());
  EXPECT_GE(lattice.coordinate(lattice.x_end - 1), 1e-4);
  EXPECT_GT(lattice.coordinate(lattice.x_sampled), flow_mesh(scene).inlet());
  EXPECT_NEAR(lattice.coordinate(0), 2.5e-6, 1e-18);
}

}  // namespace
}  // namespace clogflow
