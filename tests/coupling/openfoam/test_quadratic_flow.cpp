// The flow between the centres of cells, and the files it is read from.
#include "coupling/openfoam/quadratic_flow.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "coupling/openfoam/cell_samples.hpp"
#include "tests/coupling/flow_scene.hpp"
#include "tests/coupling/refusal.hpp"

namespace clogflow {
namespace {

using testing::HasSubstr;

constexpr int side = 6;

int cell(int i, int j, int k) { return (k * side + j) * side + i; }

// Cubes of 1 between walls at z = 0 and z = `side`, their centres moved by up to `shift`.
template <class Flow>
FoamCells cubes(const Flow& flow, double shift) {
  FoamCells cells;
  for (int k = 0; k < side; ++k)
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) {
        const double a = 3.0 * i + 5.0 * j + 7.0 * k;
        const Vec3 at{i + 0.5 + shift * std::sin(a), j + 0.5 + shift * std::cos(2 * a),
                      k + 0.5 + shift * std::sin(3 * a)};
        cells.centre.push_back(at);
        cells.velocity.push_back(flow(at));
        const auto touches = [&](int other) { cells.owner.push_back(cell(i, j, k)), cells.neighbour.push_back(other); };
        if (i + 1 < side) touches(cell(i + 1, j, k));
        if (j + 1 < side) touches(cell(i, j + 1, k));
        if (k + 1 < side) touches(cell(i, j, k + 1));
        for (const auto& [layer, z] : {std::pair(0, 0.0), {side - 1, 1.0 * side}}) {
          if (k != layer) continue;
          cells.wall.emplace_back(i + 0.5, j + 0.5, z);
          cells.wall_cell.push_back(cell(i, j, k));
        }
      }
  return cells;
}

Vec3 poiseuille(const Vec3& x) { return {x.z * (side - x.z), 0.3 * x.z * (side - x.z), 0}; }

TEST(QuadraticFlow, IsExactForPoiseuillesUpToTheWalls) {
  for (const double shift : {0.0, 0.15}) {
    const QuadraticFlow flow(cubes(poiseuille, shift));
    for (const Vec3& place : {Vec3{2.7, 3.1, 2.9}, Vec3{0.1, 5.9, 0.02}, Vec3{3.5, 0.5, 5.99}, Vec3{5.5, 2.5, 0.5}}) {
      const int at = cell(static_cast<int>(place.x), static_cast<int>(place.y), static_cast<int>(place.z));
      EXPECT_LT((flow.at(at, place) - poiseuille(place)).norm(), 2e-5) << place.z << " with a shift of " << shift;
    }
  }
}

TEST(QuadraticFlow, OfACubicFlowErrsByTheCubeOfTheCells) {
  const auto error = [](double size) {
    const auto cubic = [&](const Vec3& x) {
      return Vec3{std::pow(size * x.z, 3) - std::pow(size * side, 2) * size * x.z, 0, 0};
    };
    const Vec3 place{2.8, 3.3, 2.75};
    return (QuadraticFlow(cubes(cubic, 0)).at(cell(2, 3, 2), place) - cubic(place)).norm();
  };
  EXPECT_GT(error(1), 1e-3);
  EXPECT_NEAR(error(1) / error(0.5), 8, 0.05);
}

// The flow of one channel says nothing about that behind the wall: no face joins their cells.
TEST(QuadraticFlow, DoesNotLookThroughWalls) {
  FoamCells cells = cubes(poiseuille, 0);
  const std::size_t count = cells.centre.size();
  FoamCells two = cells;
  for (std::size_t c = 0; c < count; ++c) {
    two.centre.push_back(cells.centre[c] + Vec3{0, 0, 1.0 * side});
    two.velocity.push_back(1e3 * cells.velocity[c]);
  }
  for (std::size_t f = 0; f < cells.owner.size(); ++f) {
    two.owner.push_back(cells.owner[f] + static_cast<int>(count));
    two.neighbour.push_back(cells.neighbour[f] + static_cast<int>(count));
  }
  const Vec3 place{2.2, 2.3, 5.9};
  EXPECT_EQ(QuadraticFlow(two).at(cell(2, 2, 5), place), QuadraticFlow(cells).at(cell(2, 2, 5), place));
}

// A single layer of cells does not tell what a term across it is: it is left out, and the rest stands.
TEST(QuadraticFlow, LeavesOutWhatTheCellsDoNotTell) {
  FoamCells layer;
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      layer.centre.emplace_back(i, j, 0.5);
      layer.velocity.emplace_back(1.0 * i * i, 1.0 * j, 2);
      if (i + 1 < side) layer.owner.push_back(j * side + i), layer.neighbour.push_back(j * side + i + 1);
      if (j + 1 < side) layer.owner.push_back(j * side + i), layer.neighbour.push_back((j + 1) * side + i);
    }
  const Vec3 found = QuadraticFlow(layer).at(2 * side + 3, {3.2, 2.4, 0.5});
  EXPECT_LT((found - Vec3{3.2 * 3.2, 2.4, 2}).norm(), 1e-4);
}

TEST(CellSamples, TakeTheFlowOfTheCellThatWasSampled) {
  const FoamCells cells = cubes(poiseuille, 0);
  const FlowLattice lattice{.spacing = 0.5,
                            .x_begin = 3,
                            .x_end = 6,
                            .x_sampled = 4,
                            .y_sampled = 0,
                            .half_width = 1,
                            .height = 2,
                            .z_begin = 2,
                            .mirrored_in_z = false};
  FoamSamples where;
  where.points = lattice.sampled();
  where.velocity = {{2.5f, 0.5f, 1.5f}, {}, {2.5f, 0.5f, 1.5f}, {2.5f, 0.5f, 1.5f}};
  where.found = {1, 0, 1, 1};
  const FoamSamples found = velocities_from_cells(where, lattice, cells);
  EXPECT_NEAR(found.velocity[0][0], 1.25 * (side - 1.25), 1e-4);
  EXPECT_EQ(found.velocity[1][0], 0) << "in a wall";
  EXPECT_NEAR(found.velocity[2][0], 1.75 * (side - 1.75), 1e-4);
  EXPECT_EQ(found.found, where.found);

  where.velocity[3] = {2.5f, 0.5f, 1.6f};
  EXPECT_THAT(refusal([&] { velocities_from_cells(where, lattice, cells); }),
              HasSubstr("lies in a cell around (2.5, 0.5, 1.6) neck widths, which the mesh does not have"));
}

// Two cells before a wall of two faces, as OpenFOAM writes them.
class CellFiles : public testing::Test {
protected:
  void SetUp() override {
    const std::string head = "FoamFile { }\n// * * * //\n\n\n";
    const std::string patch = "walls { type calculated; value nonuniform List<vector> 2((0 0 0)(1 0 0)); }";
    put("7/U",
        head + "internalField nonuniform List<vector>\n2\n(\n(0.5 0 1e-3)\n(0.25 0 0)\n)\n;\nboundaryField { }\n");
    put("7/C",
        head + "internalField nonuniform List<vector>\n2\n(\n(0 0 0.5)\n(1 0 0.5)\n)\n;\nboundaryField\n{ inlet { } " +
            patch + " }\n");
    put("constant/polyMesh/owner", head + "3\n(\n0\n0\n1\n)\n");
    put("constant/polyMesh/neighbour", head + "1(1)\n");
    put("constant/polyMesh/boundary", head + "1 ( walls { type wall; nFaces 2; startFace 1; } )\n");
  }
  void put(const char* name, const std::string& text) const { write_file(scratch_.path() / name, text); }
  FoamCells read() const { return read_foam_cells(scratch_.path()); }

  ScratchFolder scratch_;
};

TEST_F(CellFiles, AreReadFromTheNewestTime) {
  put("3/U", "older");
  put("postProcessing/U", "no time");
  const FoamCells cells = read();
  ASSERT_EQ(cells.centre.size(), 2u);
  EXPECT_EQ(cells.centre[1], Vec3(1, 0, 0.5));
  EXPECT_EQ(cells.velocity[0], Vec3(0.5, 0, 1e-3));
  EXPECT_EQ(cells.wall[1], Vec3(1, 0, 0));
  EXPECT_THAT(cells.owner, testing::ElementsAre(0));
  EXPECT_THAT(cells.neighbour, testing::ElementsAre(1));
  EXPECT_THAT(cells.wall_cell, testing::ElementsAre(0, 1));
}

TEST_F(CellFiles, ThatAreCutShortOrOfAnotherMeshAreRefused) {
  put("7/U", "internalField nonuniform List<vector>\n2\n(\n(0.5 0 1e-3)\n(0.25");
  EXPECT_THAT(refusal([&] { read(); }), HasSubstr("7/U: no number behind"));
  put("7/U", "internalField nonuniform List<vector>\n2\n(\n(0.5 0 1e-3)\n(0.25 0 nan)\n)\n");
  EXPECT_THAT(refusal([&] { read(); }), HasSubstr("7/U: a vector that is not finite (diverged?)"));
  put("7/U", "internalField uniform (1 0 0);\n");
  EXPECT_THAT(refusal([&] { read(); }), HasSubstr("7/U: \"nonuniform List<vector>\" is missing"));
  put("7/U", "internalField nonuniform List<vector>\n1000000\n(\n");
  EXPECT_THAT(refusal([&] { read(); }), HasSubstr("7/U: a list of 1000000"));
  put("7/U", "internalField nonuniform List<vector>\n1\n(\n(0.5 0 1e-3)\n(0.25 0 0)\n)\n");
  EXPECT_THAT(refusal([&] { read(); }), HasSubstr("7/U: a list does not end where it should"));
  put("7/U", "internalField nonuniform List<vector>\n1\n(\n(0.5 0 1e-3)\n)\n");
  EXPECT_THAT(refusal([&] { read(); }), HasSubstr("do not belong to the same mesh; delete the file `solved`"));
  std::filesystem::remove_all(scratch_.path() / "7");
  EXPECT_THAT(refusal([&] { read(); }), HasSubstr("holds no solved time"));
}

}  // namespace
}  // namespace clogflow
