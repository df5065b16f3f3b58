// The tasks of a stretch of the particles.
#pragma once

#include "dem/kernels/kernels.hpp"

namespace clogflow {

inline ParticlePointers stretch_of(ParticlePointers p, std::size_t from, std::size_t to) {
  p.particle += from;
  p.state += record_stride * from;
  p.loads += record_stride * from;
  p.count = to - from;
  return p;
}

inline FlowTask stretch_of(FlowTask task, std::size_t from, std::size_t to) {
  task.particles = stretch_of(task.particles, from, to);
  task.ux += from, task.uy += from, task.uz += from, task.drag += from;
  return task;
}

inline AdvanceTask stretch_of(AdvanceTask task, std::size_t from, std::size_t to) {
  task.particles = stretch_of(task.particles, from, to);
  for (const double** values : {&task.ux, &task.uy, &task.uz, &task.drag, &task.turn, &task.sx, &task.sy, &task.sz})
    if (*values) *values += from;
  return task;
}

}  // namespace clogflow
