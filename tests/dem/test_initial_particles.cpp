// The CSV of initial particles: what it may hold, and every refusal read.
#include <gmock/gmock.h>

#include "dem/initial_particles.hpp"
#include "tests/coupling/refusal.hpp"
#include "tests/dem/laboratory.hpp"

namespace clog::test {
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

TEST(InitialParticles, UnknownColumn) {
  EXPECT_THAT(message("x,y,z,mass\n1,2,3,4\n"), HasSubstr(":1: unknown column \"mass\" (must be among x,y,z"));
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
  EXPECT_THAT(message("x,y,z,radius\n1,2,3,1e-300\n"), HasSubstr(":2: radius = 1e-300 m (must be from 1e-09 to 1000 m)"));
  EXPECT_THAT(message("x,y,z,radius\n1,2,3,1e4\n"), HasSubstr("radius = 10000 m (must be from"));
  EXPECT_THAT(message("x,y,z,radius\n1,2,3,-1\n"), HasSubstr("radius = -1 (must be positive)"));
}

TEST(InitialParticles, EmptyFile) {
  for (const char* text : {"", "# only a comment\n", "x,y,z\n"})
    EXPECT_THAT(message(text), HasSubstr("holds no particle (a header line and one line a particle)"));
}

}  // namespace
}  // namespace clog::test
