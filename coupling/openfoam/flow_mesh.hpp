// The block mesh of the channel: rows of hexahedra between curves that run from the axis to the
// walls.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "coupling/geometry/channel_shape.hpp"
#include "coupling/scene/scene.hpp"

namespace clogflow {

/// Where a station meets a side wall, y > 0, and the size of the cells along the wall there.
struct MeshFoot {
  Vec2 wall;                   ///< [m]
  std::optional<Vec2> middle;  ///< a point of the arc from the axis to the wall; none: straight [m]
  double before, after;        ///< size of the cells upstream and downstream [m]
};

/// A curve across the channel at which blocks meet.
struct MeshStation {
  std::string name;
  double axis;                 ///< its x on the axis [m]
  bool edge;                   ///< at an edge that points into the fluid: the velocity gradient has no limit there
  double grading;              ///< last cell over first from the axis to the wall [-]
  std::vector<MeshFoot> foot;  ///< on the upper wall, and on the lower one unless that is a mirror image
};

/// Cells between two stations, and what they look like along the walls.
struct MeshBlock {
  int cells;                             ///< along x
  double axis_grading;                   ///< last cell over first [-]
  std::vector<double> wall_grading;      ///< one a foot [-]
  std::vector<std::optional<Vec2>> arc;  ///< a point of the wall between the feet; none: straight [m]
};

/// Last cell over first from the floor to the middle.
inline constexpr double height_grading = 1.5;

struct FlowMesh {
  std::vector<MeshStation> stations;  ///< downstream
  std::vector<MeshBlock> blocks;      ///< one fewer
  int cells_across;                   ///< axis to wall
  int cells_high;                     ///< floor to middle

  double inlet() const { return stations.front().axis; }  ///< x [m]
  double outlet() const { return stations.back().axis; }  ///< x [m]
  /// Number of side walls: 1 where the plane y = 0 is one of symmetry.
  std::size_t sides() const { return stations.front().foot.size(); }
  /// How many times the mesh fits into the channel.
  double copies() const { return sides() == 1 ? 4 : 2; }
};

/// Mesh for flow.mesh_cells_per_neck. The channel is cut where the flow is developed to better than
/// 1e-3 of its mean, and continued past its end so that the outlet does not reach back.
/// \throws Error on a scene without geometry, or a shape that cannot be meshed
FlowMesh flow_mesh(const Scene& scene);

/// Edges of n cells from 0 to 1 whose last is `grading` times the first: blockMesh's own rule.
double graded_edge(int edge, int cells, double grading);

}  // namespace clogflow
