#include "ensemble/shared_flow.hpp"

#include "coupling/base/archive.hpp"

namespace clogflow {

namespace {

template <class Archive>
void exchange_head(FlowGrid& grid, std::vector<double>& corners, Archive& archive) {
  archive(grid.points[0], grid.points[1], grid.points[2], grid.origin, grid.spacing, corners, grid.scene_text,
          grid.hash);
}

std::string packed_head(const FlowGrid& grid) {
  FlowGrid head;
  head.points = grid.points, head.origin = grid.origin, head.spacing = grid.spacing;
  head.scene_text = grid.scene_text, head.hash = grid.hash;
  std::vector<double> corners = flatten(grid.walls);
  ArchiveWriter archive;
  exchange_head(head, corners, archive);
  return archive.bytes();
}

FlowGrid unpacked_head(const std::string& bytes) {
  FlowGrid grid;
  std::vector<double> corners;
  ArchiveReader archive(bytes);
  exchange_head(grid, corners, archive);
  for (std::size_t k = 0; k < corners.size(); k += 9) {
    Triangle& triangle = grid.walls.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) triangle.corner[c] = Vec3(&corners[k + 3 * c]);
  }
  return grid;
}

}  // namespace

FlowGrid shared_flow(const FlowGrid& of_first, Ranks& ranks) {
  if (ranks.count() == 1) return of_first;
  FlowGrid grid = unpacked_head(ranks.of_first(ranks.is_first() ? packed_head(of_first) : ""));
  grid.elsewhere = ranks.once_per_node(of_first.field());
  return grid;
}

}  // namespace clogflow
