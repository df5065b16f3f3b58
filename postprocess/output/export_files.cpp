#include "postprocess/output/export_files.hpp"

#include <map>
#include <numeric>

#include <nlohmann/json.hpp>

#include "coupling/base/publish_file.hpp"
#include "coupling/base/require.hpp"
#include "coupling/base/source_folder.hpp"
#include "coupling/base/text_file.hpp"
#include "postprocess/output/extended_xyz.hpp"
#include "postprocess/output/vtk_poly_data.hpp"

namespace clogflow::postprocess {
namespace {

namespace fs = std::filesystem;

fs::path made(const fs::path& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  require(!failure, "{}: cannot be made ({})", folder.string(), failure.message());
  return folder;
}

std::string snapshot_file(const RunData::Snapshot& s) {
  std::vector<VtkArray> arrays{{"radius [m]", 1, s.radius},   {"velocity [m/s]", 3, s.velocity},
                               {"spin [rad/s]", 3, s.spin},   {"force [N]", 3, s.force},
                               {"torque [N m]", 3, s.torque}, {"id", 1, s.id}};
  if (!s.species.empty()) arrays.push_back({"species", 1, s.species});
  return vtk_poly_data({.points = s.position, .corners = {}, .lines = false, .arrays = arrays, .time = s.time});
}

/// Where the particles of a snapshot stand, by their ids.
std::map<std::int64_t, std::size_t> rows_of_ids(const RunData::Snapshot& s) {
  std::map<std::int64_t, std::size_t> rows;
  for (std::size_t i = 0; i < s.id.size(); ++i) rows.emplace(s.id[i], i);
  return rows;
}

/// A line a contact, both of whose ends carry its forces: so tubes can be as wide as these.
std::string contacts_file(const RunData::Snapshot& s) {
  const RunData::Contacts& c = s.contacts;
  const auto rows = rows_of_ids(s);
  std::vector<double> points, normal_force, force;
  std::vector<std::int64_t> id;
  for (std::size_t k = 0; k < c.a.size(); ++k) {
    const std::size_t a = rows.at(c.a[k]);
    double along = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      along += static_cast<double>(c.normal[3 * k + axis]) * static_cast<double>(c.force[3 * k + axis]);
    for (const bool far : {false, true}) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double place = s.position[3 * a + axis];
        points.push_back(!far          ? place
                         : c.b[k] >= 0 ? s.position[3 * rows.at(c.b[k]) + axis]
                                       : place - s.radius[a] * static_cast<double>(c.normal[3 * k + axis]));
        force.push_back(static_cast<double>(c.force[3 * k + axis]));
      }
      normal_force.push_back(along);
      id.push_back(far ? c.b[k] : c.a[k]);
    }
  }
  const std::vector<VtkArray> arrays{{"normal force [N]", 1, normal_force}, {"force [N]", 3, force}, {"id", 1, id}};
  return vtk_poly_data({.points = points, .corners = {}, .lines = true, .arrays = arrays, .time = s.time});
}

/// A file for each snapshot. The collection comes last: what it names is there.
template <class FileOf>
fs::path export_collection(const RunData& run, const std::string& files, const fs::path& opened,
                           const FileOf& file_of) {
  std::string collection =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "<Collection>\n";
  for (std::size_t k = 0; k < run.snapshots.size(); ++k) {
    const std::string file = fmt::format("{}_{:05}.vtp", files, k);
    publish_file(file_of(run.snapshots[k]), opened.parent_path() / file);
    collection += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", run.snapshots[k].time, file);
  }
  publish_file(collection + "</Collection>\n</VTKFile>\n", opened);
  return opened;
}

fs::path export_vtk(const RunData& run, const std::string& name, const fs::path& out) {
  made(out / name);
  if (run.has_contacts) export_collection(run, name + "/contacts", out / (name + "_contacts.pvd"), contacts_file);
  return export_collection(run, name + "/snapshot", out / (name + ".pvd"), snapshot_file);
}

void widen(Box& box, const Vec3& low, const Vec3& high) {
  box.low = box.low.cwiseMin(low);
  box.high = box.high.cwiseMax(high);
}

/// Around the walls and every particle of every snapshot: a box of its own for each frame would flicker.
Box box_around(const RunData& run, const Walls& walls) {
  Box box{Vec3::Constant(1e300), Vec3::Constant(-1e300)};
  for (const Triangle& triangle : walls)
    for (const Vec3& corner : triangle.corner) widen(box, corner, corner);
  for (const RunData::Snapshot& s : run.snapshots)
    for (std::size_t i = 0; i < s.id.size(); ++i) {
      const Vec3 place(s.position[3 * i], s.position[3 * i + 1], s.position[3 * i + 2]);
      widen(box, place - Vec3::Constant(s.radius[i]), place + Vec3::Constant(s.radius[i]));
    }
  return box.low.x <= box.high.x ? box : Box{};
}

fs::path export_xyz(const RunData& run, const std::string& name, const Walls& walls, const fs::path& out) {
  const Box box = box_around(run, walls);
  std::string text;
  for (const RunData::Snapshot& snapshot : run.snapshots) text += extended_xyz(snapshot, box);
  const fs::path opened = made(out) / (name + ".xyz");
  publish_file(text, opened);
  return opened;
}

}  // namespace

fs::path export_run(const RunData& run, const std::string& name, const Walls& walls, ExportFormat format,
                    const fs::path& out) {
  require(!run.snapshots.empty(), "{}: no snapshots to export (output.snapshot_interval)", name);
  return format == ExportFormat::vtk ? export_vtk(run, name, out) : export_xyz(run, name, walls, out);
}

fs::path export_walls(const Walls& walls, const fs::path& out) {
  const std::vector<double> points = flatten(walls);
  std::vector<std::int64_t> corners(points.size() / 3);
  std::iota(corners.begin(), corners.end(), 0);
  const fs::path file = made(out) / "walls.vtp";
  publish_file(vtk_poly_data({.points = points, .corners = corners, .lines = false, .arrays = {}, .time = {}}), file);
  return file;
}

fs::path export_flow(const FlowGrid& flow, const std::string& name, const fs::path& out) {
  const fs::path file = made(out) / (name + ".hdf");
  write_flow_grid(flow, file);
  return file;
}

fs::path export_macro(const fs::path& out) {
  const fs::path file = made(out) / "show_in_paraview.py";
  const fs::path script = source_folder() / "postprocess/figures/show_in_paraview.py";
  std::string text = read_text_file(script);
  const std::string empty = "WRITTEN_TO = \"\"";
  const std::size_t place = text.find(empty);
  require(place != std::string::npos, "{}: has no line {}", script.string(), empty);
  // A text of JSON is one of Python, whatever the folder is called.
  text.replace(place, empty.size(), "WRITTEN_TO = " + nlohmann::json(fs::absolute(out).string()).dump());
  publish_file(text, file);
  return file;
}

}  // namespace clogflow::postprocess
