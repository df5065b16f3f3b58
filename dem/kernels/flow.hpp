// Fluid velocity and drag coefficient at every particle, by the nearest point of the grid.
#pragma once

#include "dem/kernels/gather.hpp"

namespace clogflow {
namespace {

/// Whole numbers of each lane, truncated.
struct Whole {
  int at[lanes];

  explicit Whole(const Lanes& values) {
    double numbers[lanes];
    store_lanes(numbers, values);
    for (int k = 0; k < lanes; ++k) at[k] = static_cast<int>(numbers[k]);
  }
};

[[gnu::always_inline]] inline void sample_some(const FlowTask& task, std::size_t i, int used) {
  const ParticlePointers& p = task.particles;
  const Columns place = load_row(p, 0, i, used);
  const Whole strip(strip_number((place.c[0] - Lanes(task.strip_start)) * Lanes(task.strips_per_length),
                                 task.last_strip, place.c[0], task.neck));
  const auto nearest = [&](int a) {
    const Lanes along = (place.c[a] - Lanes(task.origin[a])) * Lanes(task.points_per_length);
    return Whole(nearest_point(along, task.points[a] - 1.0));
  };
  const Whole i_x = nearest(0), i_y = nearest(1), i_z = nearest(2);
  std::ptrdiff_t at[lanes];
  for (int k = 0; k < lanes; ++k)
    at[k] = 3 * (i_x.at[k] + task.points[0] * (i_y.at[k] + task.points[1] * static_cast<std::ptrdiff_t>(i_z.at[k])));
  const Lanes speed_up = load(task.speed_up, strip.at);
  const auto component = [&](int c) {
    return speed_up * Lanes([&](auto k) { return static_cast<double>(task.velocity[at[k] + c]); });
  };
  store_part(task.ux + i, component(0), used);
  store_part(task.uy + i, component(1), used);
  store_part(task.uz + i, component(2), used);
  store_part(task.drag + i, load(task.drag_per_radius, strip.at) * place.c[3], used);
}

[[gnu::flatten]] void sample_nearest(const FlowTask& given) {
  const FlowTask task = given;
  std::size_t i = 0;
  for (; i + lanes <= task.particles.count; i += lanes) sample_some(task, i, lanes);
  if (i < task.particles.count) sample_some(task, i, lanes_left(i, task.particles.count));
}

}  // namespace
}  // namespace clogflow
