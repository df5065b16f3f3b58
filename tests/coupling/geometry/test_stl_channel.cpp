// Channels from STL files: what is measured in them, and what is refused.
#include "coupling/base/source_folder.hpp"
#include "coupling/geometry/stl_channel.hpp"

#include <cmath>
#include <fstream>
#include <random>
#include <regex>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "coupling/base/text_file.hpp"
#include "coupling/geometry/channel_geometry.hpp"
#include "coupling/geometry/channel_shape.hpp"
#include "coupling/geometry/stl.hpp"
#include "coupling/geometry/wall_sections.hpp"
#include "tests/coupling/flow_scene.hpp"
#include "tests/coupling/refusal.hpp"

namespace clogflow {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const auto cases = source_folder() / "tests" / "reference" / "cases";

const char* text_of_scene = R"(
[geometry]
stl = "walls.stl"
stl_unit = "1 um"
neck_width = "100 um"
[fluid]
viscosity = "1.8e-3 Pa s"
density = "1062 kg/m3"
[flow]
mean_velocity = "5 mm/s"
mesh_cells_per_neck = 12
grid_spacing = "5 um"
[particles]
diameter = "33 um"
[contact]
youngs_modulus = "3 MPa"
poisson_ratio = 0.35
[time]
end = "1 s"
)";

// A scene beside its STL file.
class StlScene {
public:
  explicit StlScene(const std::string& stl) {
    write_file(folder_.path() / "walls.stl", stl);
    write_file(folder_.path() / "scene.toml", text_of_scene);
  }
  Scene read(const Overrides& overrides = {}) const { return read_scene(folder_.path() / "scene.toml", overrides); }
  std::string refused(const Overrides& overrides = {}) const {
    const std::string message = refusal([&] { read(overrides); });
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    return message;
  }

private:
  ScratchFolder folder_;
};

std::string paper_stl() { return channel_stl(flow_scene().geometry, 1e-6); }

TEST(StlChannel, IsMeasured) {
  const StlScene file(paper_stl());
  const Scene measured = file.read(), keys = flow_scene();
  EXPECT_NEAR(measured.geometry.channel_width, 4e-4, 1e-10);
  EXPECT_NEAR(measured.geometry.neck_height, 1e-4, 1e-10);
  EXPECT_NEAR(measured.geometry.channel_length, 1e-3, 1e-9);
  EXPECT_NEAR(channel_start(measured.geometry), channel_start(keys.geometry), 1e-9);
  EXPECT_NEAR(narrowing_length(measured.geometry), narrowing_length(keys.geometry), 1e-9);
  EXPECT_NEAR(channel_end(measured.geometry), 1e-4, 1e-9);
  EXPECT_EQ(neck_start(measured.geometry), 0);
  EXPECT_DOUBLE_EQ(neck_mean_velocity(measured.geometry, measured.flow.mean_velocity), 20e-3);
  for (const auto& [from, to] : {std::pair(-1.0e-3, 0.0), {-6e-5, 3e-5}, {-5e-4, -4e-4}})
    EXPECT_NEAR(channel_volume(measured.geometry, from, to) / channel_volume(keys.geometry, from, to), 1, 1e-6);
  EXPECT_EQ(read_stl_channel(measured.geometry)->walls.size(), channel_walls(keys.geometry).size());
  // It is complete as text, with no file at hand.
  const Scene again = parse_scene(effective_scene(measured), "again");
  EXPECT_EQ(flow_inputs(again), flow_inputs(measured));
  EXPECT_EQ(effective_scene(again), effective_scene(measured));
}

TEST(StlChannel, SectionsAndPlacesInside) {
  const Scene keys = flow_scene();
  const Walls walls = channel_walls(keys.geometry);
  for (const double x : {-8e-4, -5e-5, 5e-5}) {
    const WallSection section = section_at(walls, x);
    EXPECT_NEAR(section.width(), channel_shape(keys.geometry).width(x), 1e-12);
    EXPECT_NEAR(section.height(), 1e-4, 1e-12);
    EXPECT_NEAR(section.area, channel_shape(keys.geometry).width(x) * 1e-4, 1e-15);
    const double edge = channel_shape(keys.geometry).width(x) / 2;
    const std::vector<double> heights{-1e-6, 1e-6, 5e-5, 9.9e-5, 1.01e-4};
    const std::vector<bool> between{false, true, true, true, false};
    EXPECT_EQ(inside_along_z(walls, x, 0.997 * edge, heights), between);
    EXPECT_EQ(inside_along_z(walls, x, -0.997 * edge, heights), between);
    EXPECT_EQ(inside_along_z(walls, x, 1.003 * edge, heights), std::vector<bool>(5, false));
  }
  EXPECT_EQ(section_at(walls, 1).area, 0);
  EXPECT_NEAR(straight_until(walls), -narrowing_length(keys.geometry), 1e-12);
}

// Swaps the last two corners of every facet.
std::string turned(const std::string& stl) {
  return std::regex_replace(stl, std::regex("(vertex [^\n]*\n)(vertex [^\n]*\n)(endloop)"), "$2$1$3");
}

TEST(StlChannel, NormalsMayPointOutAsOfADrawnBody) {
  const Walls in = read_stl_channel(StlScene(paper_stl()).read().geometry)->walls;
  const StlScene file(turned(paper_stl()));
  const Walls out = read_stl_channel(file.read().geometry)->walls;
  const Vec3 normal = cross(out[0].corner[1] - out[0].corner[0], out[0].corner[2] - out[0].corner[0]);
  const Vec3 wanted = cross(in[0].corner[1] - in[0].corner[0], in[0].corner[2] - in[0].corner[0]);
  EXPECT_GT(dot(normal, wanted), 0);
  EXPECT_NEAR(channel_volume(file.read().geometry, -1e-3, 0) / channel_volume(flow_scene().geometry, -1e-3, 0), 1,
              1e-6);
}

// Text of the first facet after `from`.
std::pair<std::size_t, std::size_t> facet(const std::string& stl, const std::string& from) {
  const std::size_t begin = stl.find("facet", stl.find(from) + from.size());
  return {begin, stl.find("endfacet\n", begin) + 9 - begin};
}

TEST(StlChannel, RefusesAnOpenOrTurnedSurface) {
  std::string hole = paper_stl();
  const auto [at, length] = facet(hole, "solid walls");
  hole.erase(at, length);
  EXPECT_THAT(StlScene(hole).refused(), HasSubstr("the surface is not closed (a hole of"));

  std::string one = paper_stl();
  one.replace(at, length, turned(one.substr(at, length)));
  EXPECT_THAT(StlScene(one).refused(), HasSubstr("are turned differently"));

  // A sheet inside the channel, closed to a body of no thickness with the wall's own edges.
  std::string fin = paper_stl();
  const std::string wall = fin.substr(at, length);
  const std::size_t third = wall.rfind("vertex");
  fin.insert(at, wall.substr(0, third) + "vertex -300 0 50\nendloop\nendfacet\n");
  EXPECT_THAT(StlScene(fin).refused(), AnyOf(HasSubstr("the surface is not closed"), HasSubstr("meet in the edge")));
}

TEST(StlChannel, RefusesTrianglesThatShareAnEdgeByFour) {
  // Two tetrahedra that touch along one edge, hung into the channel.
  const auto body = [](double dx) {
    const Vec3 a(-6e-4, 0, 4e-5), b(-6e-4, 0, 6e-5), c(-6e-4 + dx, 1e-5, 5e-5), d(-6e-4 + dx, -1e-5, 5e-5);
    Walls faces{{{a, b, c}}, {{b, a, d}}, {{a, c, d}}, {{b, d, c}}};
    if (dx < 0)
      for (Triangle& t : faces) std::swap(t.corner[0], t.corner[1]);
    return faces;
  };
  Walls both = body(1e-5), other = body(-1e-5);
  both.insert(both.end(), other.begin(), other.end());
  EXPECT_THAT(StlScene(paper_stl() + stl_text({{"grain", both}}, 1e-6)).refused(),
              HasSubstr("4 triangles meet in the edge at"));
}

std::string moved(const std::string& stl, const Vec3& by) {
  std::string text;
  std::istringstream lines(stl);
  for (std::string line; std::getline(lines, line);) {
    double x, y, z;
    if (std::sscanf(line.c_str(), "vertex %lf %lf %lf", &x, &y, &z) == 3)
      line = fmt::format("vertex {:.9g} {:.9g} {:.9g}", x + by.x, y + by.y, z + by.z);
    text += line + "\n";
  }
  return text;
}

TEST(StlChannel, RefusesOpeningsThatAreNotNamedOrNotInPlace) {
  EXPECT_THAT(StlScene(std::regex_replace(paper_stl(), std::regex("solid inlet"), "solid left")).refused(),
              AllOf(HasSubstr("holds no part named inlet"), HasSubstr("\"walls\", \"left\", \"outlet\"")));
  EXPECT_THAT(StlScene(std::regex_replace(paper_stl(), std::regex("solid outlet"), "solid")).refused(),
              AllOf(HasSubstr("holds no part named outlet"), HasSubstr("one without a name")));
  // Inlet and outlet exchanged.
  std::string swapped = std::regex_replace(paper_stl(), std::regex("solid inlet"), "solid x");
  swapped = std::regex_replace(swapped, std::regex("solid outlet"), "solid inlet");
  swapped = std::regex_replace(swapped, std::regex("solid x"), "solid outlet");
  EXPECT_THAT(StlScene(swapped).refused(), HasSubstr("the inlet has a corner at x = 0.0001 m"));
  EXPECT_THAT(StlScene(moved(paper_stl(), {0, 0, 20})).refused(),
              AllOf(HasSubstr("the inlet fills 1 of"), HasSubstr("z from 2e-05 to 0.00012 m")));
  EXPECT_THAT(StlScene(moved(paper_stl(), {-150, 0, 0})).refused(), HasSubstr("x = 0 must lie between"));
  EXPECT_THAT(StlScene(moved(paper_stl(), {110, 0, 0})).refused(), HasSubstr("its walls are parallel to x up to"));
}

TEST(StlChannel, ComparesTheScaleAndWhatElseTheSceneSays) {
  const StlScene file(paper_stl());
  EXPECT_THAT(file.refused({"geometry.stl_unit=1 mm"}),
              AllOf(HasSubstr("neck_width"), HasSubstr("it is 100 mm, counted in units of 0.001 m: is "
                                                       "geometry.stl_unit right?")));
  EXPECT_THAT(file.refused({"geometry.neck_width=90 um"}), HasSubstr("geometry.neck_width"));
  EXPECT_THAT(file.refused({"geometry.channel_width=500 um"}), HasSubstr("geometry.channel_width"));
  EXPECT_THAT(file.refused({"geometry.half_angle=60 deg"}), HasSubstr("the shape comes from geometry.stl"));
  EXPECT_THAT(file.refused({"geometry.stl_content=0123456789abcdef"}), HasSubstr("the file has changed"));
  EXPECT_THAT(refusal([&] { channel_stl(file.read().geometry, 1e-6); }), HasSubstr("the channel is a file already"));
}

// Whole names, and the user's own in the message.
TEST(StlChannel, TellsPartsByTheirWholeNames) {
  const std::string plate = std::regex_replace(paper_stl(), std::regex("solid walls"), "solid outlet plate");
  EXPECT_NEAR(StlScene(plate).read().geometry.outlet_position, 1e-4, 1e-9);
  EXPECT_EQ(read_stl_channel(StlScene(plate).read().geometry)->walls.size(),
            channel_walls(flow_scene().geometry).size());
  for (const char* name : {"Inlet", "INLET", "inlet_1", "inlet 2", "inle", "inlets", "inlett", "ilnet"})
    EXPECT_THAT(
        StlScene(std::regex_replace(paper_stl(), std::regex("solid inlet"), fmt::format("solid {}", name))).refused(),
        AllOf(HasSubstr(fmt::format("a part is named \"{}\"", name)), HasSubstr("the opening must be named inlet")));
  EXPECT_THAT(StlScene(std::regex_replace(paper_stl(), std::regex("solid walls"), "solid Outlet")).refused(),
              HasSubstr("a part is named \"Outlet\""));
}

TEST(StlChannel, TakesAPlateOfTheOutletForAWall) {
  const Scene scene = read_scene(cases / "outlet_with_plate.toml");
  const StlChannel channel = *read_stl_channel(scene.geometry);
  // All 80 facets but two and two of the openings.
  EXPECT_EQ(channel.walls.size() + 4, read_stl(cases / "outlet_with_plate.stl").size());
  const StlScene inlet_wall(read_text_file(cases / "inletwall.stl"));
  EXPECT_NEAR(inlet_wall.read().geometry.inlet_position, -480e-6, 1e-9);
}

std::string as_binary(const Walls& walls) {
  std::string bytes(80, ' ');
  const auto count = static_cast<std::uint32_t>(walls.size());
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  for (const Triangle& t : walls) {
    bytes.append(12, '\0');
    for (const Vec3& corner : t.corner)
      for (const double x : corner.array()) {
        const auto number = static_cast<float>(x);
        bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
      }
    bytes.append(2, '\0');
  }
  return bytes;
}

TEST(StlChannel, OfOnePartHasItsOpeningsInItsEndPlanes) {
  const ScratchFolder folder;
  write_file(folder.path() / "channel.stl", paper_stl());
  const StlScene binary(as_binary(read_stl(folder.path() / "channel.stl")));
  const StlScene text(paper_stl());
  const Scene scene = binary.read(), named = text.read();
  EXPECT_EQ(read_stl_channel(scene.geometry)->walls.size(), read_stl_channel(named.geometry)->walls.size());
  EXPECT_NEAR(scene.geometry.inlet_position, named.geometry.inlet_position, 1e-9);
  EXPECT_NEAR(scene.geometry.channel_width, 4e-4, 1e-9);
  EXPECT_NEAR(channel_volume(scene.geometry, -1e-3, 0) / channel_volume(named.geometry, -1e-3, 0), 1, 1e-6);
  // Without its ends it says so.
  Walls open = channel_walls(flow_scene().geometry);
  for (Triangle& t : open)
    for (Vec3& corner : t.corner) corner *= 1e6;
  EXPECT_THAT(StlScene(as_binary(open)).refused(),
              HasSubstr("is one part and has no facet in the plane of its smallest x"));
}

// Every corner of every facet moved by itself, as a program does that computes a seam twice.
std::string shaken(const std::string& stl, double by) {
  std::string text;
  std::istringstream lines(stl);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> shift(-by, by);
  for (std::string line; std::getline(lines, line);) {
    double x, y, z;
    if (std::sscanf(line.c_str(), " vertex %lf %lf %lf", &x, &y, &z) == 3)
      line = fmt::format("vertex {:.12g} {:.12g} {:.12g}", x + shift(random), y + shift(random), z + shift(random));
    text += line + "\n";
  }
  return text;
}

TEST(StlChannel, SeamsOfSinglePrecisionAreWelded) {
  const std::string pore = read_text_file(source_folder() / "scenes" / "pore.stl");
  const std::size_t facets = read_stl_channel(StlScene(pore).read().geometry)->walls.size();
  // 580 um long: corners of one place lie up to 4e-7 of that apart.
  for (const double share : {1e-8, 1e-7, 4e-7}) {
    const StlScene file(shaken(pore, share / 2 * 580));
    const Scene scene = file.read();
    EXPECT_EQ(read_stl_channel(scene.geometry)->walls.size(), facets) << share;
    EXPECT_NEAR(
        channel_volume(scene.geometry, -4e-4, 5e-5) / channel_volume(StlScene(pore).read().geometry, -4e-4, 5e-5), 1,
        1e-5);
  }
  EXPECT_THAT(StlScene(shaken(pore, 580e-6)).refused(),
              AllOf(HasSubstr("is not closed"), HasSubstr("geometry.stl_tolerance = 5.8e-10 m are not one")));
  // Wider seams need the user's word.
  const StlScene wide(shaken(pore, 0.003));
  EXPECT_THAT(wide.refused(), HasSubstr("is not closed"));
  EXPECT_EQ(read_stl_channel(wide.read({"geometry.stl_tolerance=0.01 um"}).geometry)->walls.size(), facets);
}

TEST(StlChannel, RefusesAToleranceThatIsNone) {
  const StlScene file(read_text_file(source_folder() / "scenes" / "pore.stl"));
  EXPECT_THAT(file.refused({"geometry.stl_tolerance=-1 um"}), HasSubstr("must be >= 0"));
  EXPECT_THAT(file.refused({"geometry.stl_tolerance=20 um"}), HasSubstr("larger than the facets there"));
  EXPECT_THAT(file.refused({"geometry.stl_tolerance=1 m"}), HasSubstr("none is left"));
  EXPECT_EQ(read_stl_channel(file.read({"geometry.stl_tolerance=0 m"}).geometry)->walls.size(),
            read_stl_channel(file.read().geometry)->walls.size());
  EXPECT_THAT(refusal([] { flow_scene({"geometry.stl_tolerance=1 um"}); }), HasSubstr("needs geometry.stl too"));
}

TEST(StlChannel, LeavesOutFacetsThatSayNothing) {
  const std::string channel = paper_stl();
  const auto [at, length] = facet(channel, "solid walls");
  std::string more = channel;
  more.insert(at, channel.substr(at, length));
  more.insert(at,
              "facet normal 0 0 0\nouter loop\nvertex 0 50 0\nvertex 0 50 40\nvertex 0 50 100\nendloop\nendfacet\n");
  const auto read = read_stl_channel(StlScene(more).read().geometry);
  EXPECT_EQ(read->walls.size(), channel_walls(flow_scene().geometry).size());
  EXPECT_THAT(read->note, AllOf(HasSubstr("1 facet without area (number 1)"),
                                HasSubstr("1 facet with the corners of another (number 3)")));
  EXPECT_EQ(read_stl_channel(StlScene(channel).read().geometry)->note, "");
}

TEST(StlChannel, MeasuresTheNeckAndPutsThePassagePlaneInIt) {
  // The neck is as long as the file says, whatever its width.
  const Scene short_neck = StlScene(channel_stl(flow_scene({"geometry.neck_length=40 um"}).geometry, 1e-6)).read();
  EXPECT_NEAR(short_neck.geometry.neck_length, 40e-6, 1e-10);
  EXPECT_NEAR(short_neck.passages.plane, 20e-6, 1e-10);
  const StlScene widening(channel_stl(
      flow_scene({"geometry.neck_length=70 um", "geometry.expansion_width=200 um", "geometry.expansion_length=100 um"})
          .geometry,
      1e-6));
  const Scene scene = widening.read();
  // A section 1 % wider than the neck lies 0.3 um behind its end.
  EXPECT_NEAR(scene.geometry.neck_length, 70e-6, 0.5e-6);
  EXPECT_NEAR(scene.passages.plane, 35e-6, 0.25e-6);
  EXPECT_GT(channel_end(scene.geometry), 170e-6);
  for (const char* plane : {"-1.2 mm", "0.3 mm"})
    EXPECT_THAT(widening.refused({fmt::format("passages.plane={}", plane)}),
                AllOf(HasSubstr("passages.plane"), HasSubstr("must be in the channel, from ")));
  EXPECT_EQ(widening.read({"passages.plane=100 um"}).passages.plane, 100e-6);
}

TEST(StlChannel, ShippedPore) {
  const Scene scene = read_scene(source_folder() / "scenes" / "pore.toml");
  const StlChannel pore = *read_stl_channel(scene.geometry);
  EXPECT_NEAR(pore.width, 3e-4, 1e-9);
  EXPECT_NEAR(pore.straight_end, -1.8e-4, 2e-6);
  // A square of 100 um with four corners of 30 um, each quarter circle four chords:
  // each leaves r^2 (1 - 4 sin(pi / 8) / 2) of its square.
  const double corners = 900e-12 * (4 - 8 * std::sin(std::numbers::pi / 8));
  EXPECT_NEAR(section_at(pore.walls, 5e-5).area, 1e-8 - corners, 1e-13);
}

Scene shipped(const char* scene, const Overrides& overrides = {}) {
  return read_scene(source_folder() / "scenes" / scene, overrides);
}

TEST(StlChannel, SeveralNecksAreMeasuredTogetherAndApart) {
  const Scene scene = shipped("two_necks.toml");
  EXPECT_NEAR(scene.geometry.neck_area, 2e-8, 1e-14);
  EXPECT_EQ(scene.geometry.inlet_area, 0);
  // 5 mm/s over 400 um, in 200 um.
  EXPECT_NEAR(neck_mean_velocity(scene.geometry, scene.flow.mean_velocity), 10e-3, 1e-9);
  EXPECT_EQ(parse_scene(effective_scene(scene), "again").geometry.neck_area, scene.geometry.neck_area);
}

TEST(StlChannel, ARoundInletHasTheRateOfItsCircle) {
  const Geometry g = shipped("pipe.toml").geometry;
  const double area = 24 * 150e-6 * 150e-6 * std::sin(M_PI / 24);
  EXPECT_NEAR(channel_flow_rate(g, 2.5e-3) / (2.5e-3 * area), 1, 1e-5);
  EXPECT_NEAR(neck_mean_velocity(g, 2.5e-3) / 22.5e-3, 1, 1e-3);
  EXPECT_NEAR(channel_volume(g, channel_start(g), channel_start(g) + 400e-6) / (400e-6 * area), 1, 1e-5);
  EXPECT_THAT(refusal([] { shipped("pipe.toml", {"geometry.inlet_area=0.09 mm2"}); }),
              AllOf(HasSubstr("geometry.inlet_area"), HasSubstr("it is")));
}

TEST(StlChannel, MeasuredKeysAreRefusedWhereKeysGiveTheShape) {
  for (const char* key : {"geometry.inlet_diameter=1 um", "geometry.inlet_area=1 um2", "geometry.neck_area=1 um2"})
    EXPECT_THAT(refusal([&] { flow_scene({key}); }), HasSubstr("is of a channel from geometry.stl: leave it out"));
  EXPECT_THAT(refusal([] { shipped("pore.toml", {"geometry.neck_area=0.02 mm2"}); }), HasSubstr("geometry.neck_area"));
}

TEST(StlChannel, AnInletThatIsNeitherRectangleNorCircleIsRefused) {
  // The pipe of scenes/pipe.stl, its circle pressed flat by a third.
  std::string pressed;
  std::istringstream lines(read_text_file(source_folder() / "scenes" / "pipe.stl"));
  for (std::string line; std::getline(lines, line);) {
    double x, y, z;
    if (std::sscanf(line.c_str(), "vertex %lf %lf %lf", &x, &y, &z) == 3)
      line = fmt::format("vertex {} {} {}", x, y, z * 2 / 3);
    pressed += line + "\n";
  }
  EXPECT_THAT(StlScene(pressed).refused(),
              HasSubstr("must be a whole rectangle, or a circle of 24 or more equal sides"));
}

}  // namespace
}  // namespace clogflow
