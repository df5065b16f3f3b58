#include "coupling/geometry/stl.hpp"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>

#include "coupling/base/require.hpp"
#include "coupling/geometry/stl_words.hpp"

namespace clogflow {

namespace {

constexpr std::size_t binary_header = 80, binary_facet = 50, head_size = 4096;

/// Areas and volumes of larger coordinates would be infinite.
constexpr double coordinate_limit = 1e90;

class TextReader {
public:
  TextReader(std::istream& stream, const std::string& name) : words_(stream), name_(name) {}

  std::vector<StlSolid> read() {
    for (std::string_view word = words_.next(); !word.empty(); word = words_.next()) {
      const bool end = is_word(word, "end");
      if (end) word = words_.next();
      if (is_word(word, "endsolid") || (end && is_word(word, "solid"))) {
        words_.name();
        open_ = false;
      } else if (is_word(word, "endfacet") || (end && is_word(word, "facet"))) {
        end_facet();
      } else if (is_word(word, "solid")) {
        solids_.push_back({words_.name(), {}});
        open_ = true;
      } else if (is_word(word, "vertex")) {
        read_vertex();
      }
    }
    require(!open_ && count_ == 0, "{}: no endsolid (the file is cut short): write it again", name_);
    return std::move(solids_);
  }

private:
  void end_facet() {
    ++facets_;
    require(count_ == 3, "{}: facet {} has {} vertices (must be 3), in line {}", name_, facets_, count_, words_.line());
    if (solids_.empty()) solids_.emplace_back();
    solids_.back().triangles.push_back(facet_);
    open_ = true;
    count_ = 0;
  }

  void read_vertex() {
    const double x = read_number(), y = read_number(), z = read_number();
    if (count_ < 3) facet_.corner[count_] = {x, y, z};
    ++count_;
  }

  double read_number() {
    const std::string_view word = words_.next();
    const std::string_view digits = word.substr(word.starts_with('+') ? 1 : 0);
    double number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    // Too large or too small for a double: infinite, or 0.
    if (error == std::errc::result_out_of_range) number = std::strtod(std::string(digits).c_str(), nullptr);
    require(error != std::errc::invalid_argument && end == digits.data() + digits.size(),
            "{}: a vertex of facet {} has no three numbers, in line {}: \"{:.40}\"", name_, facets_ + 1, words_.line(),
            word);
    return number;
  }

  StlWords words_;
  const std::string& name_;
  std::vector<StlSolid> solids_;
  Triangle facet_;
  std::size_t count_ = 0, facets_ = 0;  // vertices of this facet, facets before it
  bool open_ = false;                   // after solid, or a facet, and before endsolid
};

Walls read_binary(std::istream& stream, std::size_t count) {
  Walls walls(count);
  constexpr std::size_t together = 1000;
  std::vector<char> bytes(together * binary_facet);
  stream.seekg(binary_header + 4);
  for (std::size_t t = 0; t < count; ++t) {
    if (t % together == 0)
      stream.read(bytes.data(), static_cast<std::streamsize>(std::min(together, count - t) * binary_facet));
    float number[12];
    std::memcpy(number, bytes.data() + t % together * binary_facet, sizeof number);
    for (int c = 0; c < 3; ++c) walls[t].corner[c] = Vec3(number[3 + 3 * c], number[4 + 3 * c], number[5 + 3 * c]);
  }
  return walls;
}

// A text file's bytes 81 to 84 make a count of 500 million or more, so its size never agrees.
std::size_t binary_size(std::string_view head) {
  std::uint32_t count = 0;
  std::memcpy(&count, head.data() + binary_header, sizeof count);
  return binary_header + 4 + std::size_t{count} * binary_facet;
}

std::vector<StlSolid> read_any(std::istream& stream, std::size_t size, const std::string& name) {
  std::string head(std::min(size, head_size), '\0');
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  const bool whole = head.size() >= binary_header + 4;
  if (!whole || binary_size(head) != size) {
    stream.clear();
    stream.seekg(0);
    if (begins_as_text(head)) return TextReader(stream, name).read();
    require(whole, "{}: too short for an STL file ({} bytes)", name, size);
    throw Error(fmt::format("{}: {} bytes where {} triangles need {} (cut short, or not an STL file)", name, size,
                            (binary_size(head) - binary_header - 4) / binary_facet, binary_size(head)));
  }
  std::vector<StlSolid> solids(1);
  solids[0].triangles = read_binary(stream, (size - binary_header - 4) / binary_facet);
  require(stream.good(), "{}: cannot be read to its end", name);
  return solids;
}

}  // namespace

std::vector<StlSolid> read_stl_solids(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::ifstream stream(file, std::ios::binary);
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  require(stream.good() && !error, "{}: cannot be read: give geometry.stl an existing file", name);
  std::vector<StlSolid> solids = read_any(stream, size, name);
  std::size_t count = 0;
  for (const StlSolid& solid : solids)
    for (const Triangle& triangle : solid.triangles) {
      ++count;
      for (const Vec3& corner : triangle.corner)
        require(corner.allFinite() && corner.cwiseAbs().maxCoeff() < coordinate_limit,
                "{}: triangle {} has a coordinate that is not finite, or beyond {:.0g}", name, count, coordinate_limit);
    }
  require(count > 0, "{}: holds no triangle", name);
  return solids;
}

Walls read_stl(const std::filesystem::path& file) {
  std::vector<StlSolid> solids = read_stl_solids(file);
  Walls walls = std::move(solids[0].triangles);
  for (std::size_t k = 1; k < solids.size(); ++k)
    walls.insert(walls.end(), solids[k].triangles.begin(), solids[k].triangles.end());
  return walls;
}

std::string stl_text(const std::vector<StlSolid>& solids, double unit) {
  std::string text;
  for (const StlSolid& solid : solids) {
    text += fmt::format("solid {}\n", solid.name);
    for (const Triangle& t : solid.triangles) {
      const Vec3 n = cross(t.corner[1] - t.corner[0], t.corner[2] - t.corner[0]).normalized();
      text += fmt::format("facet normal {:.6g} {:.6g} {:.6g}\nouter loop\n", n.x, n.y, n.z);
      for (const Vec3& c : t.corner)
        text += fmt::format("vertex {:.9g} {:.9g} {:.9g}\n", c.x / unit, c.y / unit, c.z / unit);
      text += "endloop\nendfacet\n";
    }
    text += fmt::format("endsolid {}\n", solid.name);
  }
  return text;
}

}  // namespace clogflow
