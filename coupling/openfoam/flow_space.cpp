#include "coupling/openfoam/flow_space.hpp"

#include "coupling/openfoam/cell_samples.hpp"
#include "coupling/openfoam/snappy_mesh.hpp"

namespace clogflow {

FlowSpace flow_space(const Scene& scene) {
  if (!is_stl_channel(scene.geometry)) {
    const FlowMesh mesh = flow_mesh(scene);
    return {.lattice = flow_lattice(scene, mesh), .walls = {}, .unit = 1, .copies = mesh.copies(), .straight = 0};
  }
  const auto read = read_stl_channel(scene.geometry);
  const StlChannel& channel = *read;
  const SnappyMesh mesh = snappy_mesh(scene, channel);
  return {.lattice = stl_lattice(scene, channel, mesh),
          .walls = channel.walls,
          .unit = mesh.unit,
          .copies = 1,
          .straight = (mesh.inlet * mesh.unit + channel.straight_end) / 2};
}

FoamSamples read_flow_samples(const std::filesystem::path& folder, const FlowSpace& space) {
  FlowLattice lattice = space.lattice;
  lattice.spacing /= space.unit;
  if (space.walls.empty()) return read_foam_samples(foam_samples_file(folder), lattice);
  return velocities_from_cells(read_foam_samples(foam_samples_file(folder, "C"), lattice), lattice,
                               read_foam_cells(folder));
}

}  // namespace clogflow
