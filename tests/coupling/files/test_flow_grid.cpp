// flow.h5: the way there and back, VTK's own reader, and every refusal.
#include <limits>

#include <cstdlib>

#include <gmock/gmock.h>

#include "coupling/files/hdf5_file.hpp"
#include "tests/coupling/openfoam/sample_files.hpp"
#include "tests/coupling/refusal.hpp"

namespace clogflow {
namespace {

using testing::HasSubstr;

TEST(FlowGrid, ThereAndBack) {
  const FlowGrid grid = sample_grid();
  const auto file = temporary("flow.h5");
  write_flow_grid(grid, file);
  const FlowGrid read = read_flow_grid(file);
  EXPECT_EQ(read.points, grid.points);
  EXPECT_EQ(read.origin, grid.origin);
  EXPECT_EQ(read.spacing, grid.spacing);
  EXPECT_EQ(read.velocity, grid.velocity);
  EXPECT_EQ(read.solid, grid.solid);
  ASSERT_EQ(read.walls.size(), grid.walls.size());
  for (std::size_t i = 0; i < grid.walls.size(); ++i) EXPECT_EQ(read.walls[i].corner, grid.walls[i].corner);
  EXPECT_EQ(read.scene_text, grid.scene_text);
  EXPECT_EQ(read.hash, grid.hash);
  EXPECT_EQ(read.record, grid.record);
  EXPECT_THAT(files_in(file.parent_path()), testing::Each(testing::Not(testing::HasSubstr(".part"))));
}

TEST(FlowGrid, SameGridSameBytes) {
  write_flow_grid(sample_grid(), temporary("a.h5"));
  write_flow_grid(sample_grid(), temporary("b.h5"));
  EXPECT_EQ(bytes_of(temporary("a.h5")), bytes_of(temporary("b.h5")));
}

TEST(FlowGrid, WithoutWallsAndTexts) {
  FlowGrid grid = sample_grid();
  grid.walls.clear();
  grid.scene_text.clear();
  grid.record = {};
  write_flow_grid(grid, temporary("bare.h5"));
  const FlowGrid read = read_flow_grid(temporary("bare.h5"));
  EXPECT_TRUE(read.walls.empty() && read.scene_text.empty() && read.record == FlowRecord{});
}

// What ParaView does. The points come out at the places and with the values that went in.
TEST(FlowGrid, OpensInVtk) {
  if (std::system("/usr/bin/python3 -c 'from vtkmodules.vtkIOHDF import vtkHDFReader' 2> /dev/null") != 0)
    GTEST_SKIP() << "python3-vtk9 is not installed";
  write_flow_grid(sample_grid(), temporary("vtk.h5"));
  const std::string script =
      "from vtkmodules.vtkIOHDF import vtkHDFReader\n"
      "reader = vtkHDFReader()\n"
      "reader.SetFileName('" +
      temporary("vtk.h5").string() +
      "')\n"
      "reader.Update()\n"
      "image = reader.GetOutput()\n"
      "assert image.GetDimensions() == (40, 30, 20), image.GetDimensions()\n"
      "assert image.GetSpacing() == (1e-6, 1e-6, 1e-6), image.GetSpacing()\n"
      "assert image.GetOrigin() == (-1e-3, -2e-4, 0.0), image.GetOrigin()\n"
      "point = image.ComputePointId((5, 6, 7))\n"
      "expected = 3 * ((7 * 30 + 6) * 40 + 5)\n"
      "u = image.GetPointData().GetArray('U')\n"
      "assert u.GetNumberOfComponents() == 3\n"
      "assert all(abs(u.GetComponent(point, c) - (expected + c) * 1e-6) < 1e-8 for c in range(3)), "
      "u.GetTuple(point)\n"
      "solid = image.GetPointData().GetArray('solid')\n"
      "assert solid.GetValue(point) == (((7 * 30 + 6) * 40 + 5) % 7 == 0)\n";
  const auto file = temporary("vtk_check.py");
  std::ofstream(file) << script;
  EXPECT_EQ(std::system(("/usr/bin/python3 " + file.string()).c_str()), 0);
}

TEST(FlowGrid, WriterRefusesWhatReaderWould) {
  const auto refused = [](auto change) {
    FlowGrid grid = sample_grid();
    change(grid);
    return refusal([&] { write_flow_grid(grid, temporary("refused.h5")); });
  };
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(refused([&](FlowGrid& g) { g.velocity[301] = nan; }), HasSubstr("holds NaN or infinity at point 100"));
  EXPECT_THAT(refused([&](FlowGrid& g) { g.walls[0].corner[1].x = nan; }), HasSubstr("/walls/triangles holds NaN"));
  EXPECT_THAT(refused([](FlowGrid& g) { g.velocity.pop_back(); }), HasSubstr("velocity components for 24000 points"));
  EXPECT_THAT(refused([](FlowGrid& g) { g.solid.pop_back(); }), HasSubstr("23999 solid flags"));
  EXPECT_THAT(refused([](FlowGrid& g) { g.solid[3] = 2; }), HasSubstr("values other than 0 and 1"));
  EXPECT_THAT(refused([](FlowGrid& g) { g.spacing = 0; }), HasSubstr("spacing = 0 m (must be > 0)"));
  EXPECT_THAT(refused([](FlowGrid& g) { g.points[2] = 1; }), HasSubstr("at least 2 points"));
  EXPECT_THAT(refused([&](FlowGrid& g) { g.origin.x = nan; }), HasSubstr("origin is not finite"));
  EXPECT_FALSE(std::filesystem::exists(temporary("refused.h5")));
}

// A flow file of which single parts can be wrong.
struct Forgery {
  FileFormat format{.name = "clogflow flow", .version = 1};
  std::string type = "ImageData", length_unit = "m", velocity_unit = "m/s", record = "{}";
  std::vector<double> spacing{1, 1, 1};
  std::vector<std::int64_t> extent{0, 1, 0, 1, 0, 1};
  std::vector<float> velocity = std::vector<float>(24, 0.0f);
  std::vector<std::size_t> velocity_shape{2, 2, 2, 3};
  std::vector<std::size_t> walls_shape{1, 3, 3};
  bool with_walls = true;

  std::string refused() const {
    const auto file = temporary("forged.h5");
    Hdf5Writer out(file, format);
    out.group("/VTKHDF");
    out.attribute("/VTKHDF", "Type", type);
    out.attribute("/VTKHDF", "unit", length_unit);
    out.attribute("/VTKHDF", "WholeExtent", extent);
    out.attribute("/VTKHDF", "Origin", std::vector<double>(3, 0.0));
    out.attribute("/VTKHDF", "Spacing", spacing);
    out.write("/VTKHDF/PointData/U", velocity, {.unit = velocity_unit, .shape = velocity_shape});
    out.write("/VTKHDF/PointData/solid", std::vector<std::uint8_t>(8), {.unit = "1", .shape = {2, 2, 2}});
    if (with_walls) out.write("/walls/triangles", std::vector<double>(9), {.unit = "m", .shape = walls_shape});
    for (const char* name : {"scene", "hash"}) out.write_text(std::string("/provenance/") + name, "");
    out.write_text("/provenance/record", record);
    out.finish();
    return refusal([&] { read_flow_grid(file); });
  }
};

template <class Change>
std::string forged(const Change& change) {
  Forgery forgery;
  change(forgery);
  return forgery.refused();
}

TEST(FlowGrid, ReaderRefuses) {
  EXPECT_THAT(forged([](Forgery& f) {
                f.format = {"clogflow flow", 2};
              }),
              HasSubstr("has version 2 of \"clogflow flow\", this program reads version 1"));
  EXPECT_THAT(forged([](Forgery& f) {
                f.format = {"clogflow run", 1};
              }),
              HasSubstr("is a \"clogflow run\" file, a \"clogflow flow\" file is needed"));
  EXPECT_THAT(forged([](Forgery& f) { f.type = "UnstructuredGrid"; }), HasSubstr("/VTKHDF is no ImageData"));
  EXPECT_THAT(forged([](Forgery& f) { f.length_unit = "mm"; }), HasSubstr("/VTKHDF has a unit other than \"m\""));
  EXPECT_THAT(forged([](Forgery& f) { f.velocity_unit = "cm/s"; }),
              HasSubstr("/VTKHDF/PointData/U has the unit \"cm/s\" (must be \"m/s\")"));
  EXPECT_THAT(forged([](Forgery& f) { f.record = "{"; }), HasSubstr("/provenance/record is no JSON"));
  EXPECT_THAT(forged([](Forgery& f) { f.spacing = {1, 1, 2}; }), HasSubstr("Spacing differs between axes"));
  EXPECT_THAT(forged([](Forgery& f) { f.spacing = {1, 1}; }), HasSubstr("extents of a wrong length"));
  EXPECT_THAT(forged([](Forgery& f) { f.spacing = {-1, -1, -1}; }), HasSubstr("spacing = -1 m (must be > 0)"));
  EXPECT_THAT(forged([](Forgery& f) { f.extent = {0, 1, 0, 1, 0, 2}; }),
              HasSubstr("does not have the shape of the grid"));
  EXPECT_THAT(forged([](Forgery& f) { f.extent = {0, 1, 0, 1, 0, 1 << 30}; }), HasSubstr("WholeExtent is impossible"));
  EXPECT_THAT(forged([](Forgery& f) { f.extent = {1, 1, 0, 1, 0, 1}; }), HasSubstr("WholeExtent is impossible"));
  EXPECT_THAT(forged([](Forgery& f) { f.velocity = std::vector<float>(24, std::numeric_limits<float>::infinity()); }),
              HasSubstr("/VTKHDF/PointData/U holds NaN or infinity at point 0"));
  EXPECT_THAT(forged([](Forgery& f) {
                f.velocity_shape = {2, 2, 6};
              }),
              HasSubstr("/VTKHDF/PointData/U does not have the shape"));
  EXPECT_THAT(forged([](Forgery& f) { f.walls_shape = {9, 1, 1}; }), HasSubstr("/walls/triangles is not [n][3][3]"));
  EXPECT_THAT(forged([](Forgery& f) { f.with_walls = false; }), HasSubstr("/walls/triangles is missing"));
}

}  // namespace
}  // namespace clogflow
