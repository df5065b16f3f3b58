// The block mesh of the channel: corners, cell counts and gradings, as
// foam_case/system/blockMeshDict draws them.
#pragma once

#include <array>

#include "coupling/scene.hpp"

namespace clog {

/// A curve from the axis to the wall between two blocks: the arc of a circle around a point of the
/// axis.
struct MeshStation {
  double wall;                ///< x on the wall [m]
  double axis;                ///< x on the axis [m]
  std::array<double, 2> arc;  ///< x, y of the middle of the arc [m]
};

/// Cells along x in one block, with last cell over first on the axis and on the wall.
struct MeshBlock {
  int cells;
  double axis_grading, wall_grading;  ///< [-]
};

/// Last cell over first along y at each station, axis to wall, and along z, floor to middle [-].
namespace mesh_grading {
inline constexpr double inlet = 0.3, wide = 0.25, edge = 0.25, middle = 0.6, outlet = 0.7,
                        height = 1.5;
}

struct FlowMesh {
  double inlet, middle, outlet;  ///< x of the straight stations [m]
  MeshStation wide_corner, neck_edge;
  int cells_across;  ///< axis to wall
  int cells_high;    ///< floor to middle
  MeshBlock upstream, narrowing, entrance, neck;
};

/// Mesh for flow.mesh_cells_per_neck. The channel is cut where the flow is developed to better than
/// 1e-3 of its mean, and the neck is continued past its end so that the outlet does not reach back.
/// \throws Error on a scene without geometry, with an STL, or without a narrowing
FlowMesh flow_mesh(const Scene& scene);

/// Edges of n cells from 0 to 1 whose last is `grading` times the first: blockMesh's own rule.
double graded_edge(int edge, int cells, double grading);

}  // namespace clog
