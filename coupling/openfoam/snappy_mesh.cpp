#include "coupling/openfoam/snappy_mesh.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "coupling/base/require.hpp"
#include "coupling/geometry/channel_shape.hpp"
#include "coupling/geometry/stl.hpp"
#include "coupling/geometry/wall_sections.hpp"
#include "coupling/openfoam/foam_mesh.hpp"

namespace clogflow {
namespace {

// Cells are small where the section is less than this many times the neck's.
constexpr double refined_sections = 3;
constexpr int looks = 400;

// A place inside the straight part that is no corner, face or middle of cells, as shares of it.
constexpr double inside_x = 0.371, inside_y = 0.0137, inside_z = 0.4567;

int whole(double cells) { return std::max(2, static_cast<int>(std::lround(cells))); }

std::string point(double x, double y, double z) { return fmt::format("({:.12g} {:.12g} {:.12g})", x, y, z); }

Vec3 low_corner(const Walls& walls) {
  Vec3 low = Vec3::Constant(1e300);
  for (const Triangle& t : walls)
    for (const Vec3& corner : t.corner) low = low.cwiseMin(corner);
  return low;
}

Vec3 high_corner(const Walls& walls) {
  Vec3 high = Vec3::Constant(-1e300);
  for (const Triangle& t : walls)
    for (const Vec3& corner : t.corner) high = high.cwiseMax(corner);
  return high;
}

std::string background(const SnappyMesh& mesh) {
  std::string vertices;
  for (const double z : {mesh.low.z, mesh.high.z})
    for (const auto& [x, y] : {std::pair(mesh.inlet, mesh.low.y),
                               {mesh.outlet, mesh.low.y},
                               {mesh.outlet, mesh.high.y},
                               {mesh.inlet, mesh.high.y}})
      vertices += "    " + point(x, y, z) + "\n";
  return dictionary_header("blockMeshDict") + "scale 1;  // neck widths\n\nvertices\n(\n" + vertices +
         fmt::format(
             ");\n\nblocks ( hex (0 1 2 3 4 5 6 7) ({} {} {}) simpleGrading (1 1 1) );\nedges ();\n\n"
             "boundary\n(\n"
             "    inlet {{ type patch; faces ((0 4 7 3)); }}\n"
             "    outlet {{ type patch; faces ((1 2 6 5)); }}\n"
             "    outside {{ type patch; faces ((0 1 5 4) (3 7 6 2) (0 3 2 1) (4 5 6 7)); }}\n);\n",
             mesh.cells[0], mesh.cells[1], mesh.cells[2]);
}

// Places along the channel where the mass flux is taken, beside inlet and outlet.
std::vector<std::pair<std::string, double>> planes(const SnappyMesh& mesh, const StlChannel& channel) {
  const double bend = channel.straight_end / mesh.unit;
  std::vector<std::pair<std::string, double>> result;
  for (const auto& [name, x] : {std::pair("straightEnd", bend),
                                {"narrowing", bend / 2},
                                {"neckEntrance", 0.0},
                                {"neckMiddle", channel.neck_length / 2 / mesh.unit}})
    if (x > mesh.inlet && (result.empty() || x > result.back().second)) result.push_back({name, x});
  return result;
}

// The faces between cells whose middles lie on the two sides of a plane.
std::string surfaces(const SnappyMesh& mesh, const StlChannel& channel) {
  std::string text = dictionary_header("topoSetDict") + "actions\n(\n";
  const double far = 1e3;
  for (const auto& [name, x] : planes(mesh, channel)) {
    const double at = x * mesh.unit;
    text += fmt::format(
        "    {{ name before;  type cellSet; action new; source boxToCell; box {} {}; }}\n"
        "    {{ name next;    type cellSet; action new; source boxToCell; box {} {}; }}\n"
        "    {{ name surface; type faceSet; action new; source cellToFace; set before; option all; }}\n"
        "    {{ name surface; type faceSet; action subset; source cellToFace; set next; option all; }}\n"
        "    {{ name {}; type faceZoneSet; action new; source setsToFaceZone; faceSet surface; cellSet before; "
        "}}\n",
        point(-far, -far, -far), point(at, far, far), point(at, -far, -far), point(far, far, far), name);
  }
  return text + ");\n";
}

std::string inlet_condition(const Scene& scene) {
  const double rate = channel_flow_rate(scene.geometry, scene.flow.mean_velocity);
  return fmt::format(
      "// Flow that no longer changes along x, with the rate given.\n"
      "type flowRateInletVelocity;\nvolumetricFlowRate {:.12g};  // [m3/s]\nextrapolateProfile yes;\n"
      "value uniform ({:.12g} 0 0);\n",
      rate, scene.flow.mean_velocity);
}

}  // namespace

SnappyMesh snappy_mesh(const Scene& scene, const StlChannel& channel) {
  const double unit = scene.geometry.neck_width, size = 2 / scene.flow.mesh_cells_per_neck;
  SnappyMesh mesh{};
  mesh.unit = unit;
  const double development = development_widths * std::max(channel.width, channel.height);
  mesh.inlet = std::max(channel.inlet, channel.straight_end - development) / unit;
  mesh.outlet = channel.outlet / unit;
  // Whole numbers of cells across the inlet: flat walls then coincide with faces.
  const Vec3 low = low_corner(channel.walls) / unit, high = high_corner(channel.walls) / unit;
  const double across = channel.width / unit / whole(channel.width / unit / size);
  const double up = channel.height / unit / whole(channel.height / unit / size);
  const auto layers = [](double from, double to, double cell) {
    return std::pair(std::floor((from + 1e-6) / cell) - 1, std::ceil((to - 1e-6) / cell) + 1);
  };
  // y counts from the wall of the inlet.
  const double wall = -channel.width / unit / 2;
  const auto [y_low, y_high] = layers(low.y - wall, high.y - wall, across);
  const auto [z_low, z_high] = layers(low.z, high.z, up);
  mesh.low = {mesh.inlet, wall + y_low * across, z_low * up};
  mesh.high = {mesh.outlet, wall + y_high * across, z_high * up};
  mesh.cells = {whole((mesh.outlet - mesh.inlet) / size), static_cast<int>(y_high - y_low),
                static_cast<int>(z_high - z_low)};

  const double neck = section_at(channel.walls, 1e-6 * unit).area;
  mesh.refined_from = 0, mesh.refined_to = 0;
  const auto look = [&](int i) { return mesh.inlet + (i + 0.5) / looks * (mesh.outlet - mesh.inlet); };
  std::vector<double> places;
  for (int i = 0; i < looks; ++i) places.push_back(look(i) * unit);
  const std::vector<WallSection> sections = sections_at(channel.walls, places);
  for (int i = 0; i < looks; ++i) {
    if (sections[i].area > refined_sections * neck) continue;
    mesh.refined_from = std::min(mesh.refined_from, look(i));
    mesh.refined_to = std::max(mesh.refined_to, look(i));
  }
  if (mesh.refined_to > mesh.outlet - 2 * size) mesh.refined_to = mesh.outlet + size;
  return mesh;
}

FlowLattice stl_lattice(const Scene& scene, const StlChannel& channel, const SnappyMesh& mesh) {
  const double h = scene.flow.grid_spacing;
  require_layers(scene);
  const Vec3 low = low_corner(channel.walls), high = high_corner(channel.walls);
  FlowLattice lattice{};
  lattice.spacing = h;
  lattice.x_sampled = static_cast<int>(std::floor(mesh.inlet * mesh.unit / h - 0.5)) + 1;
  lattice.x_begin = lattice.x_sampled - 1;
  lattice.x_end = static_cast<int>(std::ceil(mesh.outlet * mesh.unit / h - 0.5 - 1e-6));
  lattice.half_width = static_cast<int>(std::ceil(std::max(-low.y, high.y) / h - 1e-6));
  lattice.y_sampled = -lattice.half_width;
  lattice.z_begin = static_cast<int>(std::floor(low.z / h + 1e-6));
  lattice.height = static_cast<int>(std::ceil(high.z / h - 1e-6)) - lattice.z_begin;
  lattice.mirrored_in_z = false;
  return lattice;
}

std::map<std::string, std::string> snappy_files(const Scene& scene, const StlChannel& channel, const SnappyMesh& mesh) {
  std::vector<std::string> names{"inlet"};
  for (const auto& plane : planes(mesh, channel)) names.push_back(plane.first);
  names.push_back("outlet");
  return {{"system/blockMeshDict", background(mesh)},
          {"system/topoSetDict", surfaces(mesh, channel)},
          {"system/fluxDict", flux_dictionary(names)},
          {"surfaces", surface_names(names)},
          {"meshUnit", fmt::format("{:.12g}\n", mesh.unit)},
          {"constant/inletProfile", inlet_condition(scene)},
          {"constant/triSurface/walls.stl", stl_text({{"walls", channel.walls}}, mesh.unit)}};
}

std::string snappy_entries(const SnappyMesh& mesh) {
  const double straight = inside_x;
  const double wide = mesh.high.y - mesh.low.y;
  std::string text = "\n// snappyHexMesh, in neck widths\n";
  text +=
      fmt::format("refinedFrom         {:.12g};\nrefinedTo           {:.12g};\n", mesh.refined_from, mesh.refined_to);
  text += fmt::format("insideX             {:.12g};\ninsideY             {:.12g};\ninsideZ             {:.12g};\n",
                      mesh.inlet + straight * (mesh.outlet - mesh.inlet) / mesh.cells[0], inside_y * wide,
                      inside_z * mesh.high.z);
  // All of a symmetric channel is solved, where the residuals of the small velocities along y and z, each over its
  // own size, fall last: 1e-5 changes the velocity by 1e-5 of the neck's mean. A relaxation of 0.95 takes twice the
  // iterations on cubes, 0.8 no fewer, and changes the velocity by 5e-5.
  text += fmt::format("\n// simpleFoam\nrelaxationU         {};\nresidualU           {};\n", 0.9, 1e-4);
  return text;
}

}  // namespace clogflow
