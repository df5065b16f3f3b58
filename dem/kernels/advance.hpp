// Drag, kick and drift; packing of the particles' state for the other loops.
#pragma once

#include "dem/kernels/lanes.hpp"
#include "dem/physics/drag.hpp"

namespace clog {
namespace {

void pack(const ParticlePointers& p) {
  for (std::size_t i = 0; i < p.count; ++i) {
    double* state = p.state + state_stride * i;
    state[0] = p.x[i], state[1] = p.y[i], state[2] = p.z[i], state[3] = p.radius[i];
    state[4] = p.vx[i], state[5] = p.vy[i], state[6] = p.vz[i], state[7] = p.mass[i];
    state[8] = p.wx[i], state[9] = p.wy[i], state[10] = p.wz[i], state[11] = 0;
    for (int c = 0; c < loads_stride; ++c) p.loads[loads_stride * i + c] = 0;
  }
}

void unpack(const ParticlePointers& p) {
  for (std::size_t i = 0; i < p.count; ++i) {
    const double* loads = p.loads + loads_stride * i;
    p.fx[i] = loads[0], p.fy[i] = loads[1], p.fz[i] = loads[2];
    p.tx[i] = loads[4], p.ty[i] = loads[5], p.tz[i] = loads[6];
  }
}

[[gnu::flatten]] AdvanceTally advance(const AdvanceTask& task) {
  const ParticlePointers& p = task.particles;
  const Lanes kick(task.kick), drift(task.drift), half(0.5);
  Lanes fastest(0.0), drag_work(0.0), body_work(0.0);
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
      // The drag that acted over the step, implicit or not: what the other forces leave of the kick.
      const Lanes acted = (after - before) / rate - other;
      const Lanes middle = half * (before + after) * kick * counted;
      drag_work += acted * middle;
      body_work += Lanes(body) * middle;
      speed2 += after * after;
      store_part(v + from, after, used);
      store_part(x + from, load_part(x + from, used) + drift * after, used);
    };
    push(p.x, p.vx, p.fx, task.ux, task.body_force[0]);
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
  return {__builtin_sqrt(largest), stdx::reduce(drag_work), stdx::reduce(body_work)};
}

}  // namespace
}  // namespace clog
