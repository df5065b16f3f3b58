// flow.h5: the undisturbed velocity V0 on a regular grid, the walls, and where it came from.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "coupling/base/content_hash.hpp"
#include "coupling/files/flow_record.hpp"
#include "coupling/geometry/walls.hpp"

namespace clogflow {

/// Velocity at the points origin + (i, j, k) spacing; also a VTKHDF ImageData file.
struct FlowGrid {
  std::array<int, 3> points{};      ///< number of points along x, y, z
  Vec3 origin = Vec3::Zero();       ///< of point (0, 0, 0) [m]
  double spacing = 0;               ///< [m]
  std::vector<float> velocity;      ///< V0, [z][y][x][component] [m/s]; empty where it lies elsewhere
  std::vector<std::uint8_t> solid;  ///< [z][y][x], 1 where there is no fluid
  Walls walls;                      ///< [m]
  std::string scene_text;           ///< effective scene it was made for
  std::string hash;                 ///< of flow_inputs(scene)
  FlowRecord record;

  /// V0 in memory that this process shares with others, which outlives the grid (ensemble/shared_flow).
  std::shared_ptr<const float[]> elsewhere;

  /// V0, wherever it lies.
  std::span<const float> field() const {
    if (elsewhere) return {elsewhere.get(), 3 * static_cast<std::size_t>(points[0]) * points[1] * points[2]};
    return velocity;
  }

  std::size_t index(int i, int j, int k) const { return (static_cast<std::size_t>(k) * points[1] + j) * points[0] + i; }
};

/// The corners of the walls, nine numbers a triangle, as files hold them [m]
std::vector<double> flatten(const Walls& walls);

/// Writes beside, flushes, renames. \throws Error naming the file
void write_flow_grid(const FlowGrid& grid, const std::filesystem::path& file);

/// \throws Error on an unknown version, missing unit, NaN in the field, or a truncated file
FlowGrid read_flow_grid(const std::filesystem::path& file);

}  // namespace clogflow
