// The STL reader, text and binary: what it reads, and every refusal read.
#include <algorithm>
#include <cctype>
#include <cstring>

#include <gmock/gmock.h>

#include "coupling/base/source_folder.hpp"
#include "coupling/geometry/stl.hpp"
#include "tests/coupling/refusal.hpp"
#include "tests/dem/laboratory.hpp"

namespace clogflow::test {
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

TEST(Stl, BinaryIsToldByItsSizeWhateverItBeginsWith) {
  std::string bytes = binary_stl({{0, 0, 0, 1, 0, 0, 0, 1, 0}}, 1);
  for (const char* begin : {"solid facet normal vertex endsolid", "SOLID ascii", "  solid x", "facet"}) {
    bytes.replace(0, std::string(begin).size(), begin);
    EXPECT_EQ(read(bytes).size(), 1u) << begin;
  }
}

TEST(Stl, TextInEveryForm) {
  std::string upper = text_stl;
  for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  std::string spaced = text_stl, lines = text_stl, one_line = text_stl;
  spaced.replace(spaced.find("endsolid"), 8, "end solid");
  spaced.replace(spaced.find("endfacet"), 8, "End Facet");
  spaced.replace(spaced.find("endloop"), 7, "end loop");
  for (std::size_t at = 0; (at = lines.find('\n', at)) != std::string::npos; at += 2) lines.replace(at, 1, "\r\n");
  std::ranges::replace(one_line, '\n', ' ');
  for (const std::string& text :
       {upper, spaced, lines, one_line, " \t" + text_stl, "\n\n" + text_stl, "\xef\xbb\xbf" + text_stl,
        "\xef\xbb\xbf \n# made by hand\n" + text_stl, "; solid\n! a facet\n// vertex 1 2\n" + text_stl,
        changed("1e-3", "+1e-3"), changed("solid plate\n", "")}) {
    const Walls walls = read(text);
    ASSERT_EQ(walls.size(), 1u) << text;
    EXPECT_EQ(walls[0].corner[1], Vec3(1e-3, 0, 0)) << text;
  }
}

TEST(Stl, NamesAreWhole) {
  const auto names = [](const std::string& text) {
    std::vector<std::string> result;
    for (const StlSolid& solid : read_stl_solids(ScratchFile(text, ".stl").name())) result.push_back(solid.name);
    return result;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(names(changed("solid plate", "solid outlet plate ")), Names{"outlet plate"});
  EXPECT_EQ(names(changed("solid plate", "SOLID   Outlet\tplate #2\r")), Names{"Outlet\tplate #2"});
  EXPECT_EQ(names(changed("solid plate", "solid")), Names{""});
  EXPECT_EQ(names(text_stl + text_stl), (Names{"plate", "plate"}));
  std::string one_line = text_stl;
  std::ranges::replace(one_line, '\n', ' ');
  EXPECT_EQ(names(one_line), Names{"plate"});
}

// Forms that other programs write, one cube of 12 facets each.
TEST(Stl, CasesFromOutside) {
  const auto cases = source_folder() / "tests" / "reference" / "cases";
  const Walls box = read_stl(cases / "stl" / "plain.stl");
  ASSERT_EQ(box.size(), 12u);
  for (const char* name : {"upper", "leading_space", "bom", "v_ENDSOLID", "v_endspace", "binary_solid_facet"}) {
    const Walls walls = read_stl(cases / fmt::format("{}.stl", name));
    ASSERT_EQ(walls.size(), 12u) << name;
    for (int t = 0; t < 12; ++t)
      for (int k = 0; k < 3; ++k) EXPECT_EQ(walls[t].corner[k], box[t].corner[k]) << name;
  }
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
}  // namespace clogflow::test
