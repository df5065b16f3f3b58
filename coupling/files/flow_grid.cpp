// flow.h5 as VTKHDF ImageData, so that ParaView opens it as it is, with walls and record
// beside.
#include "coupling/files/flow_grid.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/base/require.hpp"
#include "coupling/files/hdf5_file.hpp"
#include "coupling/files/record_json.hpp"

namespace clogflow {
namespace {

const FileFormat flow_format{.name = "clogflow flow", .version = 1};

constexpr const char* velocity_path = "/VTKHDF/PointData/U";
constexpr const char* solid_path = "/VTKHDF/PointData/solid";

// What reader and writer both demand; the text says what is wrong.
std::string fault(const FlowGrid& grid) {
  const auto& n = grid.points;
  if (std::ranges::any_of(n, [](int count) { return count < 2; }))
    return "the grid needs at least 2 points along each axis";
  const std::size_t count = static_cast<std::size_t>(n[0]) * n[1] * n[2];
  if (!(grid.spacing > 0) || !std::isfinite(grid.spacing))
    return fmt::format("spacing = {} m (must be > 0)", grid.spacing);
  if (!grid.origin.allFinite()) return "the origin is not finite";
  if (grid.velocity.size() != 3 * count)
    return fmt::format("{} velocity components for {} points", grid.velocity.size(), count);
  if (grid.solid.size() != count) return fmt::format("{} solid flags for {} points", grid.solid.size(), count);
  const auto bad = std::ranges::find_if(grid.velocity, [](float v) { return !std::isfinite(v); });
  if (bad != grid.velocity.end())
    return fmt::format("{} holds NaN or infinity at point {}", velocity_path, (bad - grid.velocity.begin()) / 3);
  if (std::ranges::any_of(grid.solid, [](std::uint8_t s) { return s > 1; }))
    return fmt::format("{} holds values other than 0 and 1", solid_path);
  for (const Triangle& triangle : grid.walls)
    for (const Vec3& corner : triangle.corner)
      if (!corner.allFinite()) return "/walls/triangles holds NaN or infinity";
  return {};
}

Walls unflatten(const Hdf5Array<double>& numbers) {
  Walls walls(numbers.shape[0]);
  const double* next = numbers.values.data();
  for (Triangle& triangle : walls)
    for (Vec3& corner : triangle.corner) {
      corner = Vec3(next[0], next[1], next[2]);
      next += 3;
    }
  return walls;
}

// Extent and geometry of the image; the attributes are VTK's, which knows no units.
void read_frame(const Hdf5Reader& file, FlowGrid& grid) {
  const std::string image = "/VTKHDF";
  file.check(file.text_attribute(image, "Type") == "ImageData", "/VTKHDF is no ImageData");
  file.check(file.text_attribute(image, "unit") == "m", "/VTKHDF has a unit other than \"m\"");
  const std::vector<double> extent = file.number_attribute(image, "WholeExtent");
  const std::vector<double> origin = file.number_attribute(image, "Origin");
  const std::vector<double> spacing = file.number_attribute(image, "Spacing");
  file.check(extent.size() == 6 && origin.size() == 3 && spacing.size() == 3, "/VTKHDF has extents of a wrong length");
  file.check(spacing[0] == spacing[1] && spacing[0] == spacing[2],
             "/VTKHDF@Spacing differs between axes (must be equal)");
  constexpr double most_points = 100'000;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double last = extent[2 * axis + 1];
    file.check(extent[2 * axis] == 0 && last >= 1 && last < most_points && last == std::floor(last),
               "/VTKHDF@WholeExtent is impossible");
    grid.points[axis] = static_cast<int>(last) + 1;
  }
  grid.origin = Vec3(origin[0], origin[1], origin[2]);
  grid.spacing = spacing[0];
}

}  // namespace

std::vector<double> flatten(const Walls& walls) {
  std::vector<double> numbers;
  for (const Triangle& triangle : walls)
    for (const Vec3& corner : triangle.corner) numbers.insert(numbers.end(), {corner.x, corner.y, corner.z});
  return numbers;
}

void write_flow_grid(const FlowGrid& grid, const std::filesystem::path& file) {
  const std::string wrong = fault(grid);
  require(wrong.empty(), "{}: {}", file.string(), wrong);
  const auto [nx, ny, nz] = grid.points;
  const auto size = [](int count) { return static_cast<std::size_t>(count); };

  Hdf5Writer out(file, flow_format);
  out.group("/VTKHDF");
  out.attribute("/VTKHDF", "Version", std::vector<std::int64_t>{1, 0});
  out.attribute("/VTKHDF", "Type", "ImageData");
  out.attribute("/VTKHDF", "unit", "m");
  out.attribute("/VTKHDF", "WholeExtent", std::vector<std::int64_t>{0, nx - 1, 0, ny - 1, 0, nz - 1});
  out.attribute("/VTKHDF", "Origin", std::vector<double>{grid.origin.x, grid.origin.y, grid.origin.z});
  out.attribute("/VTKHDF", "Spacing", std::vector<double>(3, grid.spacing));
  out.attribute("/VTKHDF", "Direction", std::vector<double>{1, 0, 0, 0, 1, 0, 0, 0, 1});
  out.write(velocity_path, grid.velocity, {.unit = "m/s", .shape = {size(nz), size(ny), size(nx), 3}});
  out.write(solid_path, grid.solid, {.unit = "1", .shape = {size(nz), size(ny), size(nx)}});
  out.write("/walls/triangles", flatten(grid.walls), {.unit = "m", .shape = {grid.walls.size(), 3, 3}});
  out.write_text("/provenance/scene", grid.scene_text);
  out.write_text("/provenance/hash", grid.hash);
  write_record(out, grid.record);
  out.finish();
}

FlowGrid read_flow_grid(const std::filesystem::path& file) {
  const Hdf5Reader in(file, flow_format);
  FlowGrid grid;
  read_frame(in, grid);
  Hdf5Array<float> velocity = in.read<float>(velocity_path, "m/s");
  Hdf5Array<std::uint8_t> solid = in.read<std::uint8_t>(solid_path, "1");
  const std::vector<std::size_t> shape(grid.points.rbegin(), grid.points.rend());
  in.check(solid.shape == shape, std::string(solid_path) + " does not have the shape of the grid");
  std::vector<std::size_t> vectors = shape;
  vectors.push_back(3);
  in.check(velocity.shape == vectors, std::string(velocity_path) + " does not have the shape of the grid");
  const Hdf5Array<double> walls = in.read<double>("/walls/triangles", "m");
  in.check(walls.shape.size() == 3 && walls.shape[1] == 3 && walls.shape[2] == 3, "/walls/triangles is not [n][3][3]");

  grid.velocity = std::move(velocity.values);
  grid.solid = std::move(solid.values);
  grid.walls = unflatten(walls);
  grid.scene_text = in.read_text("/provenance/scene");
  grid.hash = in.read_text("/provenance/hash");
  grid.record = read_record<FlowRecord>(in);
  const std::string wrong = fault(grid);
  in.check(wrong.empty(), wrong);
  return grid;
}

}  // namespace clogflow
