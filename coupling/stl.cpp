#include "coupling/stl.hpp"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include "coupling/require.hpp"

namespace clog {

namespace {

constexpr std::size_t binary_header = 80, binary_facet = 50;

// What follows "solid" on its line: the name, as far as it goes.
std::string solid_name(std::istringstream& words) {
  const auto begin = words.tellg();
  std::string line, name;
  std::getline(words, line);
  std::istringstream(line) >> name;
  if (name != "facet" && line.find("facet") == std::string::npos) return name;
  // All in one line: the facets must not be lost.
  words.clear();
  words.seekg(begin);
  if (name == "facet") return {};
  words >> name;
  return name;
}

std::vector<StlSolid> read_text(const std::string& content, const std::string& name) {
  std::istringstream words(content);
  std::string word;
  std::vector<StlSolid> solids;
  std::vector<Vec3> corners;
  std::size_t facets = 0;
  while (words >> word) {
    if (word == "solid") {
      solids.push_back({solid_name(words), {}});
    } else if (word == "endsolid") {
      solid_name(words);
    } else if (word == "vertex") {
      Vec3 corner;
      require(static_cast<bool>(words >> corner.x() >> corner.y() >> corner.z()),
              "{}: a vertex of facet {} has no three numbers", name, facets + 1);
      corners.push_back(corner);
    } else if (word == "endfacet") {
      ++facets;
      require(corners.size() == 3, "{}: facet {} has {} vertices (must be 3)", name, facets,
              corners.size());
      if (solids.empty()) solids.emplace_back();
      solids.back().triangles.push_back({{corners[0], corners[1], corners[2]}});
      corners.clear();
    }
  }
  require(content.find("endsolid") != std::string::npos,
          "{}: no endsolid (the file is cut short): write it again", name);
  return solids;
}

Walls read_binary(const std::string& content, const std::string& name) {
  require(content.size() >= binary_header + 4, "{}: too short for an STL file ({} bytes)", name,
          content.size());
  std::uint32_t count = 0;
  std::memcpy(&count, content.data() + binary_header, sizeof count);
  require(content.size() == binary_header + 4 + count * binary_facet,
          "{}: {} bytes where {} triangles need {} (cut short, or not an STL file)", name,
          content.size(), count, binary_header + 4 + count * binary_facet);
  Walls walls(count);
  for (std::uint32_t t = 0; t < count; ++t) {
    float number[12];
    std::memcpy(number, content.data() + binary_header + 4 + t * binary_facet, sizeof number);
    for (int c = 0; c < 3; ++c)
      walls[t].corner[c] = Vec3(number[3 + 3 * c], number[4 + 3 * c], number[5 + 3 * c]);
  }
  return walls;
}

}  // namespace

std::vector<StlSolid> read_stl_solids(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::ifstream stream(file, std::ios::binary);
  require(stream.good(), "{}: cannot be read: give geometry.stl an existing file", name);
  const std::string content((std::istreambuf_iterator<char>(stream)), {});
  // Binary files may begin with "solid" too; only a text file speaks of facets.
  const bool text = content.compare(0, 5, "solid") == 0 &&
                    (content.find("facet") != std::string::npos || content.find("endsolid") != std::string::npos);
  std::vector<StlSolid> solids;
  if (text) solids = read_text(content, name);
  else solids.push_back({"", read_binary(content, name)});
  std::size_t count = 0;
  for (const StlSolid& solid : solids)
    for (const Triangle& triangle : solid.triangles) {
      ++count;
      for (const Vec3& corner : triangle.corner)
        require(corner.allFinite(), "{}: triangle {} has a coordinate that is not finite", name, count);
    }
  require(count > 0, "{}: holds no triangle", name);
  return solids;
}

Walls read_stl(const std::filesystem::path& file) {
  Walls walls;
  for (const StlSolid& solid : read_stl_solids(file))
    walls.insert(walls.end(), solid.triangles.begin(), solid.triangles.end());
  return walls;
}

std::string stl_text(const std::vector<StlSolid>& solids, double unit) {
  std::string text;
  for (const StlSolid& solid : solids) {
    text += fmt::format("solid {}\n", solid.name);
    for (const Triangle& t : solid.triangles) {
      const Vec3 n = (t.corner[1] - t.corner[0]).cross(t.corner[2] - t.corner[0]).normalized();
      text += fmt::format("facet normal {:.6g} {:.6g} {:.6g}\nouter loop\n", n.x(), n.y(), n.z());
      for (const Vec3& c : t.corner)
        text += fmt::format("vertex {:.9g} {:.9g} {:.9g}\n", c.x() / unit, c.y() / unit, c.z() / unit);
      text += "endloop\nendfacet\n";
    }
    text += fmt::format("endsolid {}\n", solid.name);
  }
  return text;
}

}  // namespace clog
