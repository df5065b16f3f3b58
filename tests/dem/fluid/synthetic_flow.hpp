// A flow field for tests that need no OpenFOAM: parabolic in y and z, scaled to the local width so that
// every cross-section carries the same flux.
#pragma once

#include <cmath>

#include "coupling/files/flow_grid.hpp"
#include "coupling/flow/channel_drop.hpp"
#include "coupling/geometry/channel_geometry.hpp"
#include "coupling/geometry/channel_shape.hpp"
#include "coupling/scene/scene.hpp"

namespace clogflow::test {

inline FlowGrid synthetic_flow(const Scene& scene) {
  const auto& g = scene.geometry;
  FlowGrid grid;
  grid.scene_text = effective_scene(scene);
  grid.hash = content_hash(flow_inputs(scene));
  grid.spacing = g.neck_height / 20;
  const double start = channel_start(scene.geometry), h = grid.spacing;
  grid.origin = Vec3(start + h / 2, -g.channel_width / 2 + h / 2, h / 2);
  grid.points = {static_cast<int>((g.neck_length - start) / h), static_cast<int>(g.channel_width / h), 20};
  const std::size_t count = static_cast<std::size_t>(grid.points[0]) * grid.points[1] * 20;
  grid.velocity.assign(3 * count, 0.0f);
  grid.solid.assign(count, 0);
  grid.walls = channel_walls(scene.geometry);
  for (int k = 0; k < grid.points[2]; ++k)
    for (int j = 0; j < grid.points[1]; ++j)
      for (int i = 0; i < grid.points[0]; ++i) {
        const double x = grid.origin.x + i * h, y = grid.origin.y + j * h, z = grid.origin.z + k * h;
        const double width = channel_shape(scene.geometry).width(x);
        const std::size_t at = grid.index(i, j, k);
        if (std::abs(y) >= width / 2) {
          grid.solid[at] = 1;
          continue;
        }
        const double across = 2 * y / width, up = 2 * z / g.neck_height - 1;
        const double speed =
            2.25 * scene.flow.mean_velocity * g.channel_width / width * (1 - across * across) * (1 - up * up);
        const double slope =
            (channel_shape(scene.geometry).width(x + h) - channel_shape(scene.geometry).width(x - h)) / (2 * h);
        grid.velocity[3 * at] = static_cast<float>(speed);
        grid.velocity[3 * at + 1] = static_cast<float>(speed * slope * y / width);
      }
  grid.record.pressure_drop = estimated_pressure_drop(scene);
  return grid;
}

}  // namespace clogflow::test
