#include "postprocess/output/vtk_poly_data.hpp"

#include <bit>
#include <numeric>

#include <fmt/format.h>

namespace clogflow::postprocess {
namespace {

static_assert(std::endian::native == std::endian::little, "the files say that they are little endian");

/// The blocks behind the XML, each after its length in bytes, and where each begins.
class Appended {
public:
  template <class T>
  std::size_t add(std::span<const T> values) {
    const std::size_t offset = bytes_.size();
    const std::uint64_t length = values.size_bytes();
    bytes_.append(reinterpret_cast<const char*>(&length), sizeof length);
    bytes_.append(reinterpret_cast<const char*>(values.data()), length);
    return offset;
  }
  const std::string& bytes() const { return bytes_; }

private:
  std::string bytes_;
};

const char* type_name(double) { return "Float64"; }
const char* type_name(std::int64_t) { return "Int64"; }

template <class T>
std::string data_array(Appended& appended, const std::string& name, int components, std::span<const T> values) {
  return fmt::format(
      "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n",
      type_name(T{}), name, components, appended.add(values));
}

/// Cells of `size` corners each.
std::string cells(Appended& appended, const char* kind, std::span<const std::int64_t> corners, std::int64_t size) {
  std::vector<std::int64_t> ends(corners.size() / static_cast<std::size_t>(size));
  for (std::size_t i = 0; i < ends.size(); ++i) ends[i] = static_cast<std::int64_t>(i + 1) * size;
  std::string text = fmt::format("<{}>\n", kind);
  text += data_array(appended, "connectivity", 1, corners);
  text += data_array<std::int64_t>(appended, "offsets", 1, ends);
  return text + fmt::format("</{}>\n", kind);
}

}  // namespace

std::string vtk_poly_data(const VtkPolyData& data) {
  const std::size_t points = data.points.size() / 3;
  std::vector<std::int64_t> vertices(data.corners.empty() && !data.lines ? points : 0), ends(data.lines ? points : 0);
  std::iota(vertices.begin(), vertices.end(), 0);
  std::iota(ends.begin(), ends.end(), 0);
  Appended appended;
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PolyData>\n";
  if (data.time)
    text += fmt::format(
        "<FieldData><DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{}"
        "</DataArray></FieldData>\n",
        *data.time);
  text += fmt::format(
      "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" NumberOfPolys=\"{}\">\n<PointData>\n",
      points, vertices.size(), ends.size() / 2, data.corners.size() / 3);
  for (const VtkArray& array : data.arrays)
    text += std::visit([&](auto values) { return data_array(appended, array.name, array.components, values); },
                       array.values);
  text += "</PointData>\n<Points>\n" + data_array(appended, "position [m]", 3, data.points) + "</Points>\n";
  text += cells(appended, "Verts", vertices, 1);
  if (data.lines) text += cells(appended, "Lines", ends, 2);
  text += cells(appended, "Polys", data.corners, 3);
  return text + "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_" + appended.bytes() +
         "\n</AppendedData>\n</VTKFile>\n";
}

}  // namespace clogflow::postprocess
