// XDMF 2 with one hyperslab a quantity and snapshot: (start, stride, count) of rows of the array.
#include "coupling/files/snapshot_index.hpp"

#include <fmt/format.h>

#include "coupling/base/publish_file.hpp"

namespace clogflow {
namespace {

struct Column {
  const char* name;
  const char* number;  // XDMF number type and precision
  int components;
};

struct Rows {
  std::size_t first;
  std::size_t count;
  std::size_t total;
};

std::string data_item(const std::string& file, const Column& column, const Rows& rows) {
  const bool vector = column.components > 1;
  const auto shape = [&](std::size_t n) {
    return vector ? fmt::format("{} {}", n, column.components) : fmt::format("{}", n);
  };
  return fmt::format(
      "<DataItem ItemType=\"HyperSlab\" Dimensions=\"{0}\">"
      "<DataItem Dimensions=\"3 {1}\" Format=\"XML\">{2}{3} 1{4} {0}</DataItem>"
      "<DataItem Dimensions=\"{5}\" {6} Format=\"HDF\">{7}:/snapshots/{8}</DataItem></DataItem>",
      shape(rows.count), vector ? 2 : 1, rows.first, vector ? " 0" : "", vector ? " 1" : "", shape(rows.total),
      column.number, file, column.name);
}

std::string attribute(const std::string& file, const Column& column, const Rows& rows) {
  return fmt::format("    <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"Node\">{}</Attribute>\n", column.name,
                     column.components > 1 ? "Vector" : "Scalar", data_item(file, column, rows));
}

std::string grid(const std::string& file, double time, const Rows& rows) {
  constexpr const char* real = "NumberType=\"Float\" Precision=\"8\"";
  constexpr const char* whole = "NumberType=\"Int\" Precision=\"8\"";
  std::string text = fmt::format("  <Grid Name=\"particles\" GridType=\"Uniform\">\n    <Time Value=\"{}\"/>\n", time);
  text += fmt::format("    <Topology TopologyType=\"Polyvertex\" NumberOfElements=\"{}\" NodesPerElement=\"1\"/>\n",
                      rows.count);
  text +=
      fmt::format("    <Geometry GeometryType=\"XYZ\">{}</Geometry>\n", data_item(file, {"position", real, 3}, rows));
  text += attribute(file, {"velocity", real, 3}, rows);
  text += attribute(file, {"spin", real, 3}, rows);
  text += attribute(file, {"force", real, 3}, rows);
  text += attribute(file, {"torque", real, 3}, rows);
  text += attribute(file, {"radius", real, 1}, rows);
  text += attribute(file, {"id", whole, 1}, rows);
  return text + "  </Grid>\n";
}

}  // namespace

void write_snapshot_index(const RunData& run, const std::filesystem::path& run_file) {
  std::filesystem::path index = run_file;
  index.replace_extension(".xmf");
  std::size_t total = 0;
  for (const RunData::Snapshot& snapshot : run.snapshots) total += snapshot.id.size();
  if (total == 0) {
    std::error_code ignored;
    std::filesystem::remove(index, ignored);
    return;
  }
  std::string text =
      "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\"><Domain>\n"
      "<Grid Name=\"run\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  std::size_t first = 0;
  for (const RunData::Snapshot& snapshot : run.snapshots) {
    // An empty hyperslab is an error to XDMF readers, so an empty channel has no frame.
    if (!snapshot.id.empty())
      text += grid(run_file.filename().string(), snapshot.time, {first, snapshot.id.size(), total});
    first += snapshot.id.size();
  }
  text += "</Grid>\n</Domain></Xdmf>\n";
  publish_file(text, index);
}

}  // namespace clogflow
