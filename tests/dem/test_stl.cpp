// The STL reader, text and binary: what it reads, and every refusal read.
#include <cstring>

#include <gmock/gmock.h>

#include "coupling/stl.hpp"
#include "tests/coupling/refusal.hpp"
#include "tests/dem/laboratory.hpp"

namespace clog::test {
namespace {

using testing::HasSubstr;

const std::string text_stl = R"(solid plate
facet normal 0 0 1
 outer loop
  vertex 0 0 0
  vertex 1e-3 0 0
  vertex 0 2.5e-3 0
 endloop
endfacet
endsolid plate
)";

std::string binary_stl(const std::vector<std::array<float, 9>>& triangles, std::uint32_t count) {
  std::string bytes(80, ' ');
  bytes.replace(0, 5, "solid");  // many programs write this into binary files too
  bytes.append(reinterpret_cast<const char*>(&count), 4);
  for (const auto& corners : triangles) {
    bytes.append(12, '\0');
    bytes.append(reinterpret_cast<const char*>(corners.data()), 36);
    bytes.append(2, '\0');
  }
  return bytes;
}

Walls read(const std::string& content) { return read_stl(ScratchFile(content, ".stl").name()); }

std::string message(const std::string& content) {
  return refusal([&] { read(content); });
}

std::string changed(const std::string& from, const std::string& to) {
  std::string text = text_stl;
  return text.replace(text.find(from), from.size(), to);
}

TEST(Stl, Text) {
  const Walls walls = read(text_stl);
  ASSERT_EQ(walls.size(), 1u);
  EXPECT_EQ(walls[0].corner[1], Vec3(1e-3, 0, 0));
  EXPECT_EQ(walls[0].corner[2], Vec3(0, 2.5e-3, 0));
}

TEST(Stl, BinaryThatBeginsWithSolid) {
  const Walls walls = read(binary_stl({{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 0, 1, 1, 0, 1, 0, 1, 0.5f}}, 2));
  ASSERT_EQ(walls.size(), 2u);
  EXPECT_EQ(walls[1].corner[2], Vec3(0, 1, 0.5));
}

TEST(Stl, AbsentFile) {
  EXPECT_THAT(refusal([] { read_stl("no/such.stl"); }),
              HasSubstr("no/such.stl: cannot be read: give geometry.stl an existing file"));
}

TEST(Stl, BrokenText) {
  EXPECT_THAT(message(changed("1e-3 0 0", "1e-3 zero 0")), HasSubstr("a vertex of facet 1 has no three numbers"));
  EXPECT_THAT(message(changed("  vertex 0 0 0\n", "")), HasSubstr("facet 1 has 2 vertices (must be 3)"));
  EXPECT_THAT(message(changed("endsolid plate\n", "")), HasSubstr("no endsolid (the file is cut short)"));
  EXPECT_THAT(message("solid nothing\nendsolid nothing\n"), HasSubstr("holds no triangle"));
}

TEST(Stl, TextWithANumberThatIsNotFinite) {
  // The standard library's stream refuses the words; a huge exponent overflows.
  for (const char* word : {"nan", "inf", "1e999"})
    EXPECT_THAT(message(changed("1e-3", word)), testing::AnyOf(HasSubstr("no three numbers"), HasSubstr("not finite")));
}

TEST(Stl, BrokenBinary) {
  EXPECT_THAT(message("short"), HasSubstr("too short for an STL file (5 bytes)"));
  EXPECT_THAT(message(""), HasSubstr("too short for an STL file (0 bytes)"));
  EXPECT_THAT(message(binary_stl({{0, 0, 0, 1, 0, 0, 0, 1, 0}}, 2)),
              HasSubstr("134 bytes where 2 triangles need 184 (cut short, or not an STL file)"));
  EXPECT_THAT(message(binary_stl({{0, 0, 0, 1, 0, 0, 0, 1, 0}}, 4000000000u)), HasSubstr("cut short"));
  EXPECT_THAT(message(binary_stl({}, 0)), HasSubstr("holds no triangle"));
  EXPECT_THAT(message(binary_stl({{0, 0, 0, 1, 0, 0, 0, std::nanf(""), 0}}, 1)),
              HasSubstr("triangle 1 has a coordinate that is not finite"));
}

}  // namespace
}  // namespace clog::test
