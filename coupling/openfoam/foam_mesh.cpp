#include "coupling/openfoam/foam_mesh.hpp"

#include <fmt/format.h>

namespace clogflow {
namespace {

// Points of one station lie one after another: the axis and the feet in the plane z = 0, then the
// same in the symmetry plane.
class BlockMesh {
public:
  BlockMesh(const FlowMesh& mesh, double half_height) : mesh_(mesh), half_height_(half_height), rows_(mesh.sides()) {}

  std::string text() {
    for (std::size_t i = 0; i < mesh_.stations.size(); ++i) add_station(i);
    for (std::size_t i = 0; i < mesh_.blocks.size(); ++i)
      for (std::size_t s = 0; s < rows_; ++s) add_block(i, s);
    add_ends();
    const auto patch = [](const char* name, const char* type, const std::string& faces) {
      return fmt::format("    {} {{ type {}; faces\n    (\n{}    ); }}\n", name, type, faces);
    };
    return dictionary_header("blockMeshDict") + "scale 1;  // metres\n\nvertices\n(\n" + vertices_ +
           ");\n\nedges\n(\n" + edges_ +
           ");\n\n// Expansion ratios: last cell over first, on each of a block's 12 edges.\n"
           "blocks\n(\n" +
           blocks_ + ");\n\nboundary\n(\n" + patch("inlet", "patch", inlet_) + patch("outlet", "patch", outlet_) +
           patch("walls", "wall", walls_) + (rows_ == 1 ? patch("symmetryY", "symmetryPlane", middle_) : "") +
           patch("symmetryZ", "symmetryPlane", top_) + ");\n";
  }

private:
  // Number of a point: the axis is foot -1.
  int point(std::size_t station, int foot, bool high) const {
    const auto a_plane = static_cast<int>(1 + rows_);
    return (2 * static_cast<int>(station) + (high ? 1 : 0)) * a_plane + 1 + foot;
  }

  static double sign(std::size_t side) { return side == 0 ? 1 : -1; }

  void add_arc(int a, int b, double x, double y, double z) {
    edges_ += fmt::format("    arc {} {} ({:.12g} {:.12g} {:.12g})\n", a, b, x, y, z);
  }

  void add_station(std::size_t i) {
    const MeshStation& station = mesh_.stations[i];
    for (const bool high : {false, true}) {
      const double z = high ? half_height_ : 0;
      vertices_ +=
          fmt::format("    ({:.12g} 0 {:.12g})  // {}: {}\n", station.axis, z, point(i, -1, high), station.name);
      for (std::size_t s = 0; s < rows_; ++s) {
        const MeshFoot& foot = station.foot[s];
        vertices_ += fmt::format("    ({:.12g} {:.12g} {:.12g})\n", foot.wall.x(), sign(s) * foot.wall.y(), z);
        if (foot.middle)
          add_arc(point(i, -1, high), point(i, static_cast<int>(s), high), foot.middle->x(), sign(s) * foot.middle->y(),
                  z);
      }
    }
  }

  void add_block(std::size_t i, std::size_t s) {
    const MeshStation &a = mesh_.stations[i], &b = mesh_.stations[i + 1];
    const MeshBlock& block = mesh_.blocks[i];
    const int wall = static_cast<int>(s);
    // A block must be right-handed: below the axis, its y runs from the wall to the axis.
    const bool above = s == 0;
    const int low = above ? -1 : wall, up = above ? wall : -1;
    const auto corner = [&](int end, int foot, bool high) { return point(i + end, foot, high); };
    const double axis = block.axis_grading, side = block.wall_grading[s];
    const double low_x = above ? axis : side, up_x = above ? side : axis;
    const double from = above ? a.grading : 1 / a.grading, to = above ? b.grading : 1 / b.grading;
    blocks_ += fmt::format(
        "    hex ({} {} {} {} {} {} {} {}) part{} ({} {} {}) edgeGrading\n"
        "    ( {:.8g} {:.8g} {:.8g} {:.8g}  {:.8g} {:.8g} {:.8g} {:.8g}  {} {} {} {} )\n",
        corner(0, low, false), corner(1, low, false), corner(1, up, false), corner(0, up, false), corner(0, low, true),
        corner(1, low, true), corner(1, up, true), corner(0, up, true), i, block.cells, mesh_.cells_across,
        mesh_.cells_high, low_x, up_x, up_x, low_x, from, to, to, from, height_grading, height_grading, height_grading,
        height_grading);
    if (block.arc[s])
      for (const bool high : {false, true})
        add_arc(corner(0, wall, high), corner(1, wall, high), block.arc[s]->x(), sign(s) * block.arc[s]->y(),
                high ? half_height_ : 0);

    const auto along = [&](int foot) {
      return fmt::format("        ({} {} {} {})\n", corner(0, foot, false), corner(1, foot, false),
                         corner(1, foot, true), corner(0, foot, true));
    };
    const auto flat = [&](bool high) {
      return fmt::format("        ({} {} {} {})\n", corner(0, low, high), corner(1, low, high), corner(1, up, high),
                         corner(0, up, high));
    };
    walls_ += along(wall) + flat(false);
    middle_ += along(-1);
    top_ += flat(true);
  }

  void add_ends() {
    for (std::size_t s = 0; s < rows_; ++s) {
      const int wall = static_cast<int>(s);
      const auto across = [&](std::size_t i) {
        return fmt::format("        ({} {} {} {})\n", point(i, -1, false), point(i, -1, true), point(i, wall, true),
                           point(i, wall, false));
      };
      inlet_ += across(0);
      outlet_ += across(mesh_.blocks.size());
    }
  }

  const FlowMesh& mesh_;
  double half_height_;
  std::size_t rows_;
  std::string vertices_, edges_, blocks_, inlet_, outlet_, walls_, middle_, top_;
};

}  // namespace

std::string dictionary_header(const char* object) {
  return fmt::format(
      "// Generated by `clog case` from scene.toml.\n"
      "FoamFile {{ version 2.0; format ascii; class dictionary; object {}; }}\n\n",
      object);
}

std::string block_mesh_dictionary(const FlowMesh& mesh, double half_height) {
  return BlockMesh(mesh, half_height).text();
}

std::string surfaces_dictionary(const FlowMesh& mesh) {
  std::string text = dictionary_header("topoSetDict") + "actions\n(\n";
  for (std::size_t i = 1; i + 1 < mesh.stations.size(); ++i) {
    // All cells upstream of the surface, and the faces they have in common with the next block.
    text += fmt::format(
        "    {{ name before;  type cellSet; action {}; source zoneToCell; zone part{}; }}\n"
        "    {{ name next;    type cellSet; action new; source zoneToCell; zone part{}; }}\n"
        "    {{ name surface; type faceSet; action new; source cellToFace; set before; option all; "
        "}}\n"
        "    {{ name surface; type faceSet; action subset; source cellToFace; set next; option "
        "all; }}\n"
        "    {{ name {}; type faceZoneSet; action new; source setsToFaceZone; faceSet surface; "
        "cellSet before; }}\n",
        i == 1 ? "new" : "add", i - 1, i, mesh.stations[i].name);
  }
  return text + ");\n";
}

std::vector<std::string> station_names(const FlowMesh& mesh) {
  std::vector<std::string> names;
  for (const MeshStation& station : mesh.stations) names.push_back(station.name);
  return names;
}

std::string flux_dictionary(const std::vector<std::string>& names) {
  std::string text =
      "// Generated by `clog case` from scene.toml: volume flux [m3/s] of the mesh through inlet,\n"
      "// surfaces between blocks and outlet; at the inlet it counts outwards and is negative.\n";
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool end = i == 0 || i + 1 == names.size();
    text += fmt::format(
        "{0}Flux {{ type surfaceFieldValue; libs (fieldFunctionObjects); regionType {1}; name {0}; "
        "operation sum; fields (phi); writeFields no; log no; }}\n",
        names[i], end ? "patch" : "faceZone");
  }
  return text;
}

std::string surface_names(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += name + "\n";
  return text;
}

}  // namespace clogflow
