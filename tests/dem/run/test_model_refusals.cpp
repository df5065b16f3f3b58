// What this version does not model is refused, never ignored.
#include <gmock/gmock.h>

#include "dem/run/model.hpp"
#include "tests/coupling/refusal.hpp"
#include "tests/dem/channel_scene.hpp"

namespace clogflow::test {
namespace {

using testing::HasSubstr;

TEST(Model, RefusesAFidelityThatIsNotResolved) {
  for (const auto& [overrides, key] : std::vector<std::pair<Overrides, std::string>>{
           {{"fidelity.preset=fast"}, "fidelity.preset"}, {{"fidelity.tolerance=0.05"}, "fidelity.tolerance"}}) {
    EXPECT_THAT(refusal([&, overrides = overrides] { make_model(short_channel_scene(overrides), nullptr, {}); }),
                HasSubstr(key + " has not been turned into keys"));
  }
}

TEST(Model, RefusesMoreParticlesThanAnyCoreFinishes) {
  EXPECT_THAT(refusal([] { make_model(short_channel_scene({"particles.diameter=1 nm"}), nullptr, {}); }),
              HasSubstr("the channel would hold"));
}

/// A floor, as an STL file, with one more facet.
std::string floor_file(const std::string& more = "") {
  return "solid s\nfacet\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendfacet\n" + more + "endsolid s\n";
}

Scene on_walls(const ScratchFile& file) {
  Scene scene = laboratory_scene({}, 1e-4);
  scene.geometry.present = true;
  scene.geometry.stl = file.name();
  return scene;
}

TEST(Model, SaysWhereWallsFromAFileAreOpen) {
  const ScratchFile file(floor_file(), ".stl");
  EXPECT_THAT(make_model(on_walls(file), nullptr, {}).walls_note,
              testing::AllOf(HasSubstr(file.name() + ": the walls are open along 1 rim, the shortest 3.41 m around"),
                             testing::Not(HasSubstr("\n"))));
  std::vector<std::string> said;
  Simulation simulation(on_walls(file), nullptr, 1);
  simulation.on_note([&](const std::string& line) { said.push_back(line); });
  simulation.run();
  EXPECT_THAT(said, testing::Contains(HasSubstr("the walls are open")));
}

TEST(Model, SaysWhichFacetsOfAFileAreLeftOut) {
  const ScratchFile twice(floor_file("facet\nvertex 1 0 0\nvertex 0 1 0\nvertex 0 0 0\nendfacet\n"), ".stl");
  EXPECT_THAT(make_model(on_walls(twice), nullptr, {}).walls_note,
              HasSubstr(twice.name() + ": 1 facet with the corners of another (number 2) is left out"));
  const ScratchFile flat(floor_file("facet\nvertex 1 0 0\nvertex 2 0 0\nvertex 3 0 0\nendfacet\n"), ".stl");
  EXPECT_THAT(make_model(on_walls(flat), nullptr, {}).walls_note,
              HasSubstr(flat.name() + ": 1 facet without area (number 2) is left out"));
}

// A closed body whose base has two thin facets beside its edge from (0, 0) to (10, 0): the second lies within 0.01 of
// the first, but not of that edge.
std::string thin_facets() {
  const std::array<Vec3, 6> p{Vec3(0, 0, 0),     Vec3(10, 0, 0),     Vec3(5, -8, 0),
                              Vec3(6, 0.009, 0), Vec3(3, 0.0135, 0), Vec3(5, 0, 5)};
  std::string text = "solid body\n";
  for (const auto& facet :
       {std::array{0, 1, 2}, {0, 3, 1}, {0, 4, 3}, {0, 2, 5}, {2, 1, 5}, {1, 3, 5}, {3, 4, 5}, {4, 0, 5}}) {
    text += "facet\n";
    for (const int k : facet) text += fmt::format("vertex {} {} {}\n", p[k].x, p[k].y, p[k].z);
    text += "endfacet\n";
  }
  return text + "endsolid body\n";
}

TEST(Model, RefusesAToleranceThatOpensTheWalls) {
  const ScratchFile file(thin_facets(), ".stl");
  Scene scene = on_walls(file);
  EXPECT_EQ(make_model(scene, nullptr, {}).walls_note, "");
  EXPECT_EQ(make_model(scene, nullptr, {}).walls.size(), 8u);
  scene.geometry.stl_tolerance = 0.01;
  EXPECT_THAT(refusal([&] { make_model(scene, nullptr, {}); }),
              testing::AllOf(HasSubstr(file.name() + ": 2 facets without area"), HasSubstr("that opens the surface")));
  scene.geometry.stl_tolerance = 0.02;
  EXPECT_THAT(make_model(scene, nullptr, {}).walls_note, HasSubstr("2 facets without area"));
}

TEST(Model, RefusesAToleranceLargerThanTheFacetsUnderTheFilesName) {
  const ScratchFile file(floor_file(), ".stl");
  Scene scene = on_walls(file);
  scene.geometry.stl_tolerance = 2;
  EXPECT_THAT(refusal([&] { make_model(scene, nullptr, {}); }),
              testing::AllOf(HasSubstr(file.name()), HasSubstr("none is left")));
}

}  // namespace
}  // namespace clogflow::test
