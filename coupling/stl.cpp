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

Walls read_text(const std::string& content, const std::string& name) {
  std::istringstream words(content);
  std::string word;
  Walls walls;
  std::vector<Vec3> corners;
  while (words >> word) {
    if (word == "vertex") {
      Vec3 corner;
      require(static_cast<bool>(words >> corner.x() >> corner.y() >> corner.z()),
              "{}: a vertex of facet {} has no three numbers", name, walls.size() + 1);
      corners.push_back(corner);
    } else if (word == "endfacet") {
      require(corners.size() == 3, "{}: facet {} has {} vertices (must be 3)", name,
              walls.size() + 1, corners.size());
      walls.push_back({{corners[0], corners[1], corners[2]}});
      corners.clear();
    }
  }
  require(word == "endsolid" || content.find("endsolid") != std::string::npos,
          "{}: no endsolid (the file is cut short): write it again", name);
  return walls;
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

Walls read_stl(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::ifstream stream(file, std::ios::binary);
  require(stream.good(), "{}: cannot be read: give geometry.stl an existing file", name);
  const std::string content((std::istreambuf_iterator<char>(stream)), {});
  // Binary files may begin with "solid" too; only a text file speaks of facets.
  const bool text = content.compare(0, 5, "solid") == 0 &&
                    (content.find("facet") != std::string::npos || content.find("endsolid") != std::string::npos);
  const Walls walls = text ? read_text(content, name) : read_binary(content, name);
  require(!walls.empty(), "{}: holds no triangle", name);
  for (std::size_t t = 0; t < walls.size(); ++t)
    for (const Vec3& corner : walls[t].corner)
      require(corner.allFinite(), "{}: triangle {} has a coordinate that is not finite", name, t + 1);
  return walls;
}

}  // namespace clog
