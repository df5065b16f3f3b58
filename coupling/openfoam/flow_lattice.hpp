// Where the points of the regular grid lie, and which of them OpenFOAM samples.
#pragma once

#include <array>

#include "coupling/openfoam/flow_mesh.hpp"
#include "coupling/scene/scene.hpp"

namespace clogflow {

/// Points ((i + 1/2) h, (j + 1/2) h, (k + 1/2) h), y mirrored about 0. They reach from one plane
/// before the inlet of the mesh, where the flow is developed, to past the end of the channel;
/// further upstream the first plane stands for all. Simulated are z <= height/2 and, where the
/// channel is symmetric, y > 0.
struct FlowLattice {
  double spacing;             ///< h [m]
  int x_begin, x_end;         ///< range of i; x_end is past the last
  int x_sampled;              ///< first i inside the mesh
  int y_sampled;              ///< first j inside the mesh: 0, or -half_width
  int half_width;             ///< j runs from -half_width to half_width - 1
  int height;                 ///< number of k
  int z_begin = 0;            ///< first k
  bool mirrored_in_z = true;  ///< simulated is the lower half alone

  double coordinate(int index) const { return (index + 0.5) * spacing; }  ///< [m]

  /// Numbers of sampled points along x, y, z; the plane z = height/2 included.
  std::array<int, 3> sampled() const {
    return {x_end - x_sampled, half_width - y_sampled, mirrored_in_z ? (height + 1) / 2 : height};
  }
};

/// \throws Error when flow.grid_spacing does not divide geometry.neck_height
void require_layers(const Scene& scene);

/// \throws Error when flow.grid_spacing does not divide geometry.neck_height
FlowLattice flow_lattice(const Scene& scene, const FlowMesh& mesh);

}  // namespace clogflow
