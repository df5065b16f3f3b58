// Drag, kick and drift.
#pragma once

#include "dem/kernels/gather.hpp"
#include "dem/physics/drag.hpp"

namespace clogflow {
namespace {

/// The particles of one vector, a row of their state after the other.
struct Moved {
  Columns place, motion, spin, force, torque;

  Moved(const ParticlePointers& p, std::size_t from, int used)
      : place(load_row(p, 0, from, used)),
        motion(load_row(p, 4, from, used)),
        spin(load_row(p, 8, from, used)),
        force(load_row(p, 12, from, used)),
        torque(load_row(p, 16, from, used)) {}

  /// Everything but the loads.
  [[gnu::always_inline]] void store(const ParticlePointers& p, std::size_t from, int used) const {
    double* first = p.state + record_stride * from;
    const Columns* rows[] = {&place, &motion, &spin};
    for (int r = 0; r < 3; ++r) {
      const Lanes(&c)[4] = rows[r]->c;
      Records({c[0], c[1], c[2]}, c[3]).store(first + 4 * r, record_stride, used);
    }
  }
};

[[gnu::always_inline]] inline void clear_loads(const ParticlePointers& p, std::size_t from, int used) {
  const Records none({Lanes(0.0), Lanes(0.0), Lanes(0.0)});
  double* first = p.loads + record_stride * from;
  none.store(first, record_stride, used);
  none.store(first + 4, record_stride, used);
}

[[gnu::always_inline]] inline Lanes cubed(const Lanes& value) { return value * value * value; }

/// \tparam weighs, floats  as the task's: without weights they cost nothing
template <bool weighs, bool floats>
[[gnu::flatten]] AdvanceTally advance_all(const AdvanceTask& given) {
  const AdvanceTask task = given;
  const ParticlePointers& p = task.particles;
  const Lanes kick(task.kick), drift(task.drift), half(0.5), plane(task.passage);
  const Lanes too_fast(task.too_fast * task.too_fast);
  const double* fluid[3] = {task.ux, task.uy, task.uz};
  const double* turning[3] = {task.sx, task.sy, task.sz};
  const Lanes per_kick(1 / task.kick);
  const bool equal = task.mass > 0;
  Lanes rate(equal ? task.kick / task.mass : 0.0), spin_rate(equal ? task.kick / task.inertia : 0.0);
  Lanes fastest(0.0), drag_work(0.0), body_work(0.0);
  bool crossed = false;
  for (std::size_t from = 0; from < p.count; from += lanes) {
    const int used = lanes_left(from, p.count);
    const Lanes counted([&](auto k) { return static_cast<int>(k) < used ? 1.0 : 0.0; });
    Moved m(p, from, used);
    if (!equal) rate = kick / m.motion.c[3], spin_rate = kick / m.spin.c[3];
    const Lanes force_per_kick = m.motion.c[3] * per_kick;
    const Lanes c = task.drag ? load_part(task.drag + from, used) : Lanes(0.0);
    const Lanes share = task.implicit_drag ? implicit_drag_factor(rate * c) : Lanes(1.0);
    const Lanes x_before = m.place.c[0];
    Lanes speed2(0.0);
    for (int a = 0; a < 3; ++a) {
      const Lanes before = m.motion.c[a];
      Lanes external(task.body_force[a]);
      if constexpr (weighs) external += m.motion.c[3] * task.weight_per_mass[a];
      if constexpr (floats) external -= cubed(m.place.c[3]) * task.buoyancy[a];
      const Lanes other = m.force.c[a] + external;
      const Lanes drag = task.drag ? c * (load_part(fluid[a] + from, used) - before) : Lanes(0.0);
      const Lanes after = before + share * rate * (other + drag);
      // The drag that acted over the step, implicit or not: what the other forces leave of the
      // kick.
      const Lanes acted = (after - before) * force_per_kick - other;
      const Lanes middle = half * (before + after) * kick * counted;
      drag_work += acted * middle;
      body_work += external * middle;
      speed2 += after * after;
      m.motion.c[a] = after;
      m.place.c[a] += drift * after;
    }
    if (stdx::any_of(x_before < plane && m.place.c[0] >= plane)) crossed = true;
    const Lanes ct = task.turn ? load_part(task.turn + from, used) : Lanes(0.0);
    const Lanes spin_share = task.implicit_drag ? implicit_drag_factor(spin_rate * ct) : Lanes(1.0);
    for (int a = 0; a < 3; ++a) {
      Lanes torque = m.torque.c[a];
      if (task.turn) torque += ct * (load_part(turning[a] + from, used) - m.spin.c[a]);
      m.spin.c[a] += spin_share * spin_rate * torque;
    }
    m.store(p, from, used);
    if (stdx::all_of(speed2 < too_fast)) clear_loads(p, from, used);
    // Not max(): a NaN must get in and stay, whatever follows it.
    fastest = select(speed2 > fastest || speed2 != speed2, speed2, fastest);
  }
  double largest = 0;
  for (int k = 0; k < lanes; ++k)
    if (fastest[k] > largest || fastest[k] != fastest[k]) largest = fastest[k];
  return {__builtin_sqrt(largest), stdx::reduce(drag_work), stdx::reduce(body_work), crossed};
}

[[maybe_unused]] AdvanceTally advance(const AdvanceTask& task) {
  if (task.floats) return advance_all<true, true>(task);
  return task.weighs ? advance_all<true, false>(task) : advance_all<false, false>(task);
}

}  // namespace
}  // namespace clogflow
