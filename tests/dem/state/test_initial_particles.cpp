// The CSV of initial particles: what it may hold, and every refusal read.
#include <gmock/gmock.h>

#include "coupling/base/source_folder.hpp"
#include "dem/state/initial_particles.hpp"
#include "tests/coupling/refusal.hpp"
#include "tests/dem/laboratory.hpp"

namespace clogflow::test {
namespace {

using testing::HasSubstr;

std::vector<Particle> read(const std::string& text) {
  const ScratchFile file(text);
  Scene scene = laboratory_scene({1e6, 0.3, 1000, 0.02}, 1e-6);
  scene.particles.initial = file.name();
  return read_initial_particles(scene);
}

std::string message(const std::string& text) {
  return refusal([&] { read(text); });
}

TEST(InitialParticles, AllColumnsInAnyOrder) {
  const auto p = read("wz,radius,x,y,z,vx,vy,vz,wx,wy\n1,2,3,4,5,6,7,8,9,10\n");
  ASSERT_EQ(p.size(), 1u);
  EXPECT_EQ(p[0].wz, 1);
  EXPECT_EQ(p[0].radius, 2);
  EXPECT_EQ(p[0].x, 3);
  EXPECT_EQ(p[0].vz, 8);
  EXPECT_EQ(p[0].wy, 10);
}

TEST(InitialParticles, MissingColumnsHaveDefaults) {
  const auto p = read("# a comment\nx, y ,z\r\n\n1e-3,-2,3\r\n# another\n4,5,6\n");
  ASSERT_EQ(p.size(), 2u);
  EXPECT_EQ(p[0].radius, 0.01) << "half the diameter";
  EXPECT_EQ(p[0].vx, 0);
  EXPECT_EQ(p[0].y, -2);
  EXPECT_EQ(p[1].z, 6);
}

TEST(InitialParticles, WithoutAFileThereAreNone) {
  EXPECT_TRUE(read_initial_particles(laboratory_scene({}, 1e-6)).empty());
}

TEST(InitialParticles, AbsentFile) {
  Scene scene = laboratory_scene({}, 1e-6);
  scene.particles.initial = "no/such.csv";
  EXPECT_THAT(refusal([&] { read_initial_particles(scene); }),
              HasSubstr("no/such.csv: cannot be read: give particles.initial an existing file"));
}

TEST(InitialParticles, MassesAreTheScenes) {
  EXPECT_THAT(message("x,y,z,mass\n1,2,3,4\n"),
              HasSubstr(":1: column \"mass\" (masses follow from particles.density): leave it out"));
}

InitialParticles from_case(const std::string& name) {
  Scene scene = laboratory_scene({3e6, 0.35, 2500, 33e-6}, 1e-7);
  scene.particles.initial = source_folder() / "tests/reference/cases" / name;
  return read_initial_file(scene);
}

TEST(InitialParticles, OfEveryDialectAreTheSame) {
  const auto plain = from_case("plain.csv").particles;
  ASSERT_EQ(plain.size(), 2u);
  for (const char* name : {"bom.csv", "numpy_header.csv", "tabs.csv", "liggghts_named.csv", "paraview.csv"}) {
    const auto p = from_case(name).particles;
    ASSERT_GE(p.size(), 1u) << name;
    EXPECT_EQ(p[0].x, plain[0].x) << name;
    EXPECT_EQ(p[0].y, plain[0].y) << name;
    EXPECT_EQ(p[0].z, plain[0].z) << name;
    EXPECT_EQ(p[0].radius, plain[0].radius) << name;
  }
}

TEST(InitialParticles, HeadersWithUnitsDiametersAndOtherSeparators) {
  for (const char* text :
       {"x [um],y [um],z [um],diameter [um],vx [mm/s]\n100,50,5,33,5\n",
        "x_um;y_um;z_um;diameter_um;vx (mm/s)\n100;50;5;33;5\n", "# X_um Y_um Z_um radius_um vx\n100  50 5 16.5 5e-3\n",
        "\"x\",\"y\",\"z\",\"radius\",\"vx\"\n1e-4,5e-5,5e-6,16.5e-6,5e-3\n",
        "# a pack of 1\n# x,y,z,diameter,vx\nx,y,z,diameter,vx\n1e-4,5e-5,5e-6,33e-6,5e-3\n"}) {
    const auto p = read(text);
    ASSERT_EQ(p.size(), 1u) << text;
    EXPECT_EQ(p[0].x, 100e-6) << text;
    EXPECT_EQ(p[0].y, 50e-6) << text;
    EXPECT_EQ(p[0].z, 5e-6) << text;
    EXPECT_EQ(p[0].radius, 16.5e-6) << text;
    EXPECT_EQ(p[0].vx, 5e-3) << text;
  }
}

TEST(InitialParticles, ColumnsThatSayNothingAreNamed) {
  EXPECT_THAT(from_case("liggghts_named.csv").note, HasSubstr("are left out: \"id\", \"type\""));
  EXPECT_EQ(from_case("plain.csv").note, "");
}

TEST(InitialParticles, EachCoordinateIsThereOnce) {
  EXPECT_THAT(refusal([] { from_case("no_y.csv"); }), HasSubstr("no_y.csv:1: there is no column y"));
  EXPECT_THAT(refusal([] { from_case("dup_col.csv"); }),
              HasSubstr("dup_col.csv:1: column \"x\" says again what another column says"));
  EXPECT_THAT(message("x,y,z,radius,diameter\n1,2,3,4,8\n"), HasSubstr("column \"diameter\" says again"));
  EXPECT_THAT(message("x [um],y,z\n1,2,3\n"),
              HasSubstr("x is in \"um\" and y in \"m\": give all coordinates in one unit"));
  EXPECT_THAT(message("x [s],y [s],z [s]\n1,2,3\n"),
              HasSubstr(":1: column \"x\" has the unit \"s\" (must be that of a length)"));
  EXPECT_THAT(message("1,2,3\n4,5,6\n"), HasSubstr(":1: there is no column x"));
  EXPECT_THAT(message("x;y;z\n1,5;2;3\n"),
              HasSubstr(":2: \"1,5\" is not a finite number (decimals are written with a point)"));
}

/// What a simulation of a scene of tests/reference/cases says of its particles.
std::string placement(const std::string& scene, const std::string& particles, Overrides overrides = {}) {
  const auto folder = source_folder() / "tests/reference/cases";
  overrides.push_back("particles.initial=" + (folder / particles).string());
  return refusal([&] { Simulation(read_scene(folder / scene, overrides), nullptr, 1); });
}

TEST(InitialPlacement, NamesFileLineAndWhatIsOverlapped) {
  EXPECT_THAT(
      placement("box.toml", "overlap.csv"),
      HasSubstr("overlap.csv:3: the particle at (0.000105, 0.0001, 5e-05) m overlaps that of line 2 by 2.8e-05 m"));
  EXPECT_THAT(placement("box.toml", "overlap_6um.csv"),
              HasSubstr("overlap_6um.csv:3: the particle at (0.000127, 0.0001, 0.0001) m overlaps that of line 2 by "
                        "6e-06 m, 0.18 of"));
  EXPECT_THAT(placement("box.toml", "same.csv"),
              HasSubstr("same.csv:3: the particle at (0.0001, 0.0001, 5e-05) m overlaps that of line 2 by 3.3e-05 m"));
  EXPECT_THAT(placement("box.toml", "micrometres.csv"),
              testing::AllOf(HasSubstr("micrometres.csv:2: the particle at (100, 100, 50) m lies outside the walls, "
                                       "which reach from (0, 0, 0) to (0.0002, 0.0002, 0.0002) m"),
                             HasSubstr("\"x [um],y [um],z [um]\"")));
  EXPECT_THAT(placement("chan_lab.toml", "in_the_wall_and_beyond.csv", {"flow.source=uniform"}),
              HasSubstr("in_the_wall_and_beyond.csv:3: the particle at (0.00015, 0, 5e-05) m lies beyond the outlet"));
  EXPECT_THAT(refusal([] {
                Simulation(read_scene(source_folder() / "tests/reference/cases/box.toml",
                                      {"box.max=[\"200 um\",\"200 um\",\"60 um\"]", "particles.diameter=33 um"}),
                           nullptr, 1);
              }),
              HasSubstr("plain.csv:3: the particle at (0.0001, 5e-05, 0.0001) m lies outside the walls"));
}

std::string placed(const std::string& scene, const std::string& text) {
  const ScratchFile file(text);
  return refusal([&] {
    Simulation(read_scene(source_folder() / "tests/reference/cases" / scene,
                          {"flow.source=uniform", "particles.initial=" + file.name()}),
               nullptr, 1);
  });
}

TEST(InitialPlacement, RefusesWhatLiesInTheSolid) {
  EXPECT_THAT(placed("chan_lab.toml", "x_um,y_um,z_um\n-100,0,50\n-20,150,50\n"),
              HasSubstr(":3: the particle at (-2e-05, 0.00015, 5e-05) m lies in the solid"));
  EXPECT_THAT(
      placed("chan_lab.toml", "x_um,y_um,z_um\n-100,0,12\n"),
      HasSubstr(":2: the particle at (-0.0001, 0, 1.2e-05) m overlaps a wall by 4.5e-06 m, 0.14 of its diameter"));
}

TEST(InitialPlacement, KeepsSmallElasticOverlaps) {
  const ScratchFile file("x_um,y_um,z_um\n50,50,16\n82,50,16.4\n");
  Simulation(read_scene(source_folder() / "tests/reference/cases/box.toml", {"particles.initial=" + file.name()}),
             nullptr, 1);
  const ScratchFile channel("x_um,y_um,z_um\n-100,0,16\n-100,33,50\n0,0,50\n90,33,50\n");
  Simulation(read_scene(source_folder() / "tests/reference/cases/chan_lab.toml",
                        {"flow.source=uniform", "particles.initial=" + channel.name()}),
             nullptr, 1);
}

TEST(InitialPlacement, RefusesAFilledStartOntoThem) {
  EXPECT_THAT(placement("chan_lab.toml", "plain.csv", {"flow.source=uniform", "inlet.start=filled"}),
              HasSubstr("inlet.start = \"filled\" scatters its own particles"));
}

TEST(InitialParticles, WrongNumberOfFields) {
  EXPECT_THAT(message("x,y,z\n1,2,3\n1,2\n"), HasSubstr(":3: 2 fields where the header has 3"));
  EXPECT_THAT(message("x,y,z\n1,2,3,4\n"), HasSubstr(":2: 4 fields where the header has 3"));
}

TEST(InitialParticles, WhatIsNoFiniteNumber) {
  for (const char* field : {"", "abc", "1.0m", "nan", "inf", "1e999", "1 2"})
    EXPECT_THAT(message(fmt::format("x,y,z\n1,{},3\n", field)),
                HasSubstr(fmt::format(":2: \"{}\" is not a finite number", field)));
}

TEST(InitialParticles, RadiusThatIsNotPositive) {
  EXPECT_THAT(message("x,y,z,radius\n1,2,3,0\n"), HasSubstr(":2: radius = 0 (must be positive)"));
  EXPECT_THAT(message("x,y,z,radius\n1,2,3,1e-300\n"),
              HasSubstr(":2: radius = 1e-300 m (must be from 1e-09 to 1000 m)"));
  EXPECT_THAT(message("x,y,z,radius\n1,2,3,1e4\n"), HasSubstr("radius = 10000 m (must be from"));
  EXPECT_THAT(message("x,y,z,radius\n1,2,3,-1\n"), HasSubstr("radius = -1 (must be positive)"));
}

TEST(InitialParticles, EmptyFile) {
  for (const char* text : {"", "# only a comment\n", "x,y,z\n"})
    EXPECT_THAT(message(text), HasSubstr("holds no particle (a header line and one line a particle)"));
}

}  // namespace
}  // namespace clogflow::test
