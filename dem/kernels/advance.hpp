// Drag, kick and drift; packing of the particles' state for the other loops.
#pragma once

#include "dem/kernels/lanes.hpp"
#include "dem/physics/drag.hpp"

namespace clog {
namespace {

/// State of the particles from i on into records, and their loads cleared.
[[gnu::always_inline]] inline void pack_some(const ParticlePointers& p, std::size_t i, int used) {
  const auto store = [&](double* to, const double* x, const double* y, const double* z,
                         const Lanes& w) {
    Records({load_part(x + i, used), load_part(y + i, used), load_part(z + i, used)}, w)
        .store(to + record_stride * i, record_stride, used);
  };
  store(p.state, p.x, p.y, p.z, load_part(p.radius + i, used));
  store(p.state + 4, p.vx, p.vy, p.vz, load_part(p.mass + i, used));
  store(p.state + 8, p.wx, p.wy, p.wz, Lanes(0.0));
  const Records none({Lanes(0.0), Lanes(0.0), Lanes(0.0)});
  none.store(p.loads + record_stride * i, record_stride, used);
  none.store(p.loads + record_stride * i + 4, record_stride, used);
}

void pack(const ParticlePointers& p) {
  std::size_t i = 0;
  for (; i + lanes <= p.count; i += lanes) pack_some(p, i, lanes);
  if (i < p.count) pack_some(p, i, lanes_left(i, p.count));
}

[[gnu::always_inline]] inline void unpack_some(const ParticlePointers& p, std::size_t i, int used) {
  int rows[lanes];
  for (int k = 0; k < lanes; ++k) rows[k] = k < used ? k : 0;
  const auto take = [&](const double* from, double* x, double* y, double* z) {
    const Columns columns = load_records(from + record_stride * i, record_stride, rows);
    store_part(x + i, columns.c[0], used);
    store_part(y + i, columns.c[1], used);
    store_part(z + i, columns.c[2], used);
  };
  take(p.loads, p.fx, p.fy, p.fz);
  take(p.loads + 4, p.tx, p.ty, p.tz);
}

void unpack(const ParticlePointers& p) {
  std::size_t i = 0;
  for (; i + lanes <= p.count; i += lanes) unpack_some(p, i, lanes);
  if (i < p.count) unpack_some(p, i, lanes_left(i, p.count));
}

[[gnu::flatten]] AdvanceTally advance(const AdvanceTask& task) {
  const ParticlePointers& p = task.particles;
  const Lanes kick(task.kick), drift(task.drift), half(0.5);
  Lanes fastest(0.0), drag_work(0.0), body_work(0.0);
  bool crossed = false;
  for (std::size_t from = 0; from < p.count; from += lanes) {
    const int used = lanes_left(from, p.count);
    const Lanes counted([&](auto k) { return static_cast<int>(k) < used ? 1.0 : 0.0; });
    const Lanes rate = kick / load_part(p.mass + from, used);
    const Lanes c = task.drag ? load_part(task.drag + from, used) : Lanes(0.0);
    const Lanes share = task.implicit_drag ? implicit_drag_factor(rate * c) : Lanes(1.0);
    Lanes speed2(0.0);
    const auto push = [&](double* x, double* v, const double* f, const double* u, double body) {
      const Lanes before = load_part(v + from, used);
      const Lanes other = load_part(f + from, used) + Lanes(body);
      const Lanes drag = task.drag ? c * (load_part(u + from, used) - before) : Lanes(0.0);
      const Lanes after = before + share * rate * (other + drag);
      // The drag that acted over the step, implicit or not: what the other forces leave of the
      // kick.
      const Lanes acted = (after - before) / rate - other;
      const Lanes middle = half * (before + after) * kick * counted;
      drag_work += acted * middle;
      body_work += Lanes(body) * middle;
      speed2 += after * after;
      store_part(v + from, after, used);
      store_part(x + from, load_part(x + from, used) + drift * after, used);
    };
    const Lanes x_before = load_part(p.x + from, used);
    push(p.x, p.vx, p.fx, task.ux, task.body_force[0]);
    const Lanes plane(task.passage);
    if (stdx::any_of(x_before < plane && load_part(p.x + from, used) >= plane)) crossed = true;
    push(p.y, p.vy, p.fy, task.uy, task.body_force[1]);
    push(p.z, p.vz, p.fz, task.uz, task.body_force[2]);
    const Lanes spin_rate = kick / load_part(p.inertia + from, used);
    const Lanes ct = task.turn ? load_part(task.turn + from, used) : Lanes(0.0);
    const Lanes spin_share = task.implicit_drag ? implicit_drag_factor(spin_rate * ct) : Lanes(1.0);
    const auto spin = [&](double* w, const double* t, const double* s) {
      const Lanes before = load_part(w + from, used);
      Lanes torque = load_part(t + from, used);
      if (task.turn) torque += ct * (load_part(s + from, used) - before);
      store_part(w + from, before + spin_share * spin_rate * torque, used);
    };
    spin(p.wx, p.tx, task.sx);
    spin(p.wy, p.ty, task.sy);
    spin(p.wz, p.tz, task.sz);
    // Not max(): a NaN must get in and stay, whatever follows it.
    fastest = select(speed2 > fastest || speed2 != speed2, speed2, fastest);
  }
  double largest = 0;
  for (int k = 0; k < lanes; ++k)
    if (fastest[k] > largest || fastest[k] != fastest[k]) largest = fastest[k];
  return {__builtin_sqrt(largest), stdx::reduce(drag_work), stdx::reduce(body_work), crossed};
}

}  // namespace
}  // namespace clog
