#include "coupling/openfoam/cell_samples.hpp"

#include <cstring>
#include <unordered_map>

#include "coupling/base/require.hpp"
#include "coupling/openfoam/quadratic_flow.hpp"

namespace clogflow {
namespace {

using Place = std::array<float, 3>;

// Both files hold the same digits of a centre, so that it is found by its bits.
struct PlaceHash {
  std::size_t operator()(const Place& place) const {
    std::size_t hash = 0;
    for (const float each : place) {
      std::uint32_t bits = 0;
      std::memcpy(&bits, &each, sizeof bits);
      hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
    }
    return hash ^ (hash >> 32);
  }
};

// 0 for -0, which is another pattern of bits.
Place place_of(const Vec3& at) {
  return {static_cast<float>(at.x) + 0.0f, static_cast<float>(at.y) + 0.0f, static_cast<float>(at.z) + 0.0f};
}

}  // namespace

FoamSamples velocities_from_cells(FoamSamples where, const FlowLattice& lattice, const FoamCells& cells) {
  const QuadraticFlow flow(cells);
  std::unordered_map<Place, int, PlaceHash> cell_at;
  cell_at.reserve(cells.centre.size());
  for (std::size_t c = 0; c < cells.centre.size(); ++c) cell_at.emplace(place_of(cells.centre[c]), static_cast<int>(c));

  const auto [nx, ny, nz] = where.points;
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        const std::size_t at = where.index(i, j, k);
        if (!where.found[at]) continue;
        auto& value = where.velocity[at];
        const auto found = cell_at.find(place_of({value[0], value[1], value[2]}));
        require(found != cell_at.end(),
                "a point of the grid lies in a cell around ({}, {}, {}) neck widths, which the mesh does not have "
                "(samples of another mesh?); delete the file `solved` of the case and run its Allrun again",
                value[0], value[1], value[2]);
        const Vec3 velocity = flow.at(
            found->second, {lattice.coordinate(i + lattice.x_sampled), lattice.coordinate(j + lattice.y_sampled),
                            lattice.coordinate(k + lattice.z_begin)});
        for (int c = 0; c < 3; ++c) value[c] = static_cast<float>(velocity[c]);
      }
  return where;
}

}  // namespace clogflow
