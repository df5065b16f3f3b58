// The hot loops over SIMD vectors. Included once per instruction set, under flags that no other file
// has; it must therefore use nothing that another file could also instantiate (no containers). The
// loops are flattened: every formula inlined, or vectors would travel through memory.
#pragma once

#include "dem/kernels.hpp"
#include "dem/physics/drag.hpp"
#include "dem/physics/lubrication.hpp"

namespace clog {
namespace {

using Lanes = stdx::native_simd<double>;
constexpr int lanes = static_cast<int>(Lanes::size());
using Index = const int*;

Lanes load(const double* values, Index at) {
  return Lanes([&](auto k) { return values[at[k]]; });
}

Vector<Lanes> load(const double* x, const double* y, const double* z, Index at) {
  return {load(x, at), load(y, at), load(z, at)};
}

void add(double* values, Index at, Lanes amount, int used) {
  for (int k = 0; k < used; ++k) values[at[k]] += amount[k];
}

void add(double* x, double* y, double* z, Index at, const Vector<Lanes>& amount, int used) {
  add(x, at, amount.x, used);
  add(y, at, amount.y, used);
  add(z, at, amount.z, used);
}

/// A vector's worth of entries of a list; the last may be partly filled, its spare lanes then repeat
/// the last entry and are never written.
struct Batch {
  int slot[lanes];
  int used;
};

Batch take(const int* list, std::size_t from, std::size_t count) {
  Batch batch;
  const std::size_t left = count - from;
  batch.used = left < static_cast<std::size_t>(lanes) ? static_cast<int>(left) : lanes;
  for (int k = 0; k < lanes; ++k) {
    const std::size_t at = from + (k < batch.used ? k : batch.used - 1);
    batch.slot[k] = list ? list[at] : static_cast<int>(at);
  }
  return batch;
}

template <ContactTerms terms>
Springs<Lanes> load_springs(const SpringPointers& s, Index at) {
  const Lanes zero(0.0);
  Springs<Lanes> springs{{zero, zero, zero}, {zero, zero, zero}, zero};
  if constexpr (terms.sliding)
    springs.sliding = load(s.component[0], s.component[1], s.component[2], at);
  if constexpr (terms.rolling)
    springs.rolling = load(s.component[3], s.component[4], s.component[5], at);
  if constexpr (terms.torsion) springs.torsion = load(s.component[6], at);
  return springs;
}

void store(double* values, const Batch& batch, Lanes amount) {
  for (int k = 0; k < batch.used; ++k) values[batch.slot[k]] = amount[k];
}

template <ContactTerms terms>
void store_springs(const SpringPointers& s, const Batch& batch, const Springs<Lanes>& springs) {
  if constexpr (terms.sliding) {
    store(s.component[0], batch, springs.sliding.x);
    store(s.component[1], batch, springs.sliding.y);
    store(s.component[2], batch, springs.sliding.z);
  }
  if constexpr (terms.rolling) {
    store(s.component[3], batch, springs.rolling.x);
    store(s.component[4], batch, springs.rolling.y);
    store(s.component[5], batch, springs.rolling.z);
  }
  if constexpr (terms.torsion) store(s.component[6], batch, springs.torsion);
}

void forget(const SpringPointers& s, std::size_t slot) {
  if (!s.touching[slot]) return;
  s.touching[slot] = 0;
  for (double* component : s.component) component[slot] = 0;
}

/// The pair (or particle and wall) of a batch, its lists filled by `gap`.
struct Sorted {
  std::size_t touching = 0, lubricated = 0;
};

/// Sorts one entry by its gap into touching, lubricated or neither.
void sort_entry(double gap, std::size_t slot, const LubricationLaw& lubrication,
                const SpringPointers& springs, int* touching, int* lubricated, Sorted& sorted) {
  if (gap < 0) {
    touching[sorted.touching++] = static_cast<int>(slot);
    springs.touching[slot] = 1;
    return;
  }
  forget(springs, slot);
  if (lubrication.viscosity > 0 && gap <= lubrication.farthest &&
      (lubrication.clamp || gap >= lubrication.nearest))
    lubricated[sorted.lubricated++] = static_cast<int>(slot);
}

struct PairGeometry {
  int i[lanes], j[lanes];
  Vector<Lanes> normal;
  Lanes distance, radius_i, radius_j;
};

PairGeometry pair_geometry(const ParticlePointers& p, const int* first, const int* second,
                           const Batch& batch) {
  PairGeometry g;
  for (int k = 0; k < lanes; ++k) {
    g.i[k] = first[batch.slot[k]];
    g.j[k] = second[batch.slot[k]];
  }
  const Vector<Lanes> apart = load(p.x, p.y, p.z, g.i) - load(p.x, p.y, p.z, g.j);
  g.distance = sqrt(dot(apart, apart));
  g.normal = (Lanes(1.0) / g.distance) * apart;
  g.radius_i = load(p.radius, g.i);
  g.radius_j = load(p.radius, g.j);
  return g;
}

void lubricate_batch(const ParticlePointers& p, const LubricationLaw& law, const PairGeometry& g,
                     int used) {
  const Lanes gap = g.distance - g.radius_i - g.radius_j;
  const Lanes film = max(gap, Lanes(law.nearest));
  const Lanes radius = g.radius_i * g.radius_j / (g.radius_i + g.radius_j);
  const auto acts = gap <= Lanes(law.farthest);
  const Lanes coefficient =
      select(acts, lubrication_coefficient(law.viscosity, radius, film), Lanes(0.0));
  const Vector<Lanes> velocity = load(p.vx, p.vy, p.vz, g.i) - load(p.vx, p.vy, p.vz, g.j);
  const Vector<Lanes> force = (-(coefficient * dot(velocity, g.normal))) * g.normal;
  add(p.fx, p.fy, p.fz, g.i, force, used);
  add(p.fx, p.fy, p.fz, g.j, -force, used);
}

template <ContactTerms terms>
[[gnu::flatten]] ContactTally collide_pairs(const PairTask& task) {
  const ParticlePointers& p = task.particles;
  Sorted sorted;
  for (std::size_t from = 0; from < task.count; from += lanes) {
    const Batch batch = take(nullptr, from, task.count);
    const PairGeometry g = pair_geometry(p, task.first, task.second, batch);
    const Lanes gap = g.distance - g.radius_i - g.radius_j;
    for (int k = 0; k < batch.used; ++k)
      sort_entry(gap[k], from + k, task.lubrication, task.springs, task.touching, task.lubricated,
                 sorted);
  }
  Lanes deepest(0.0);
  for (std::size_t from = 0; from < sorted.touching; from += lanes) {
    const Batch batch = take(task.touching, from, sorted.touching);
    const PairGeometry g = pair_geometry(p, task.first, task.second, batch);
    ContactGeometry<Lanes> contact;
    contact.normal = g.normal;
    contact.overlap = g.radius_i + g.radius_j - g.distance;
    contact.radius = g.radius_i * g.radius_j / (g.radius_i + g.radius_j);
    const Lanes mass_i = load(p.mass, g.i), mass_j = load(p.mass, g.j);
    contact.mass = mass_i * mass_j / (mass_i + mass_j);
    contact.arm_i = g.radius_i - Lanes(0.5) * contact.overlap;
    contact.arm_j = g.radius_j - Lanes(0.5) * contact.overlap;
    const ContactMotion<Lanes> motion{load(p.vx, p.vy, p.vz, g.i) - load(p.vx, p.vy, p.vz, g.j),
                                      load(p.wx, p.wy, p.wz, g.i), load(p.wx, p.wy, p.wz, g.j)};
    Springs<Lanes> springs = load_springs<terms>(task.springs, batch.slot);
    const ContactLoads<Lanes> loads =
        contact_loads<terms>(task.law, contact, motion, task.dt, springs);
    store_springs<terms>(task.springs, batch, springs);
    add(p.fx, p.fy, p.fz, g.i, loads.force, batch.used);
    add(p.fx, p.fy, p.fz, g.j, -loads.force, batch.used);
    if constexpr (terms.sliding || terms.rolling || terms.torsion) {
      add(p.tx, p.ty, p.tz, g.i, loads.torque_i, batch.used);
      add(p.tx, p.ty, p.tz, g.j, loads.torque_j, batch.used);
    }
    deepest = max(deepest, contact.overlap);
  }
  for (std::size_t from = 0; from < sorted.lubricated; from += lanes) {
    const Batch batch = take(task.lubricated, from, sorted.lubricated);
    lubricate_batch(p, task.lubrication, pair_geometry(p, task.first, task.second, batch),
                    batch.used);
  }
  return {static_cast<std::int64_t>(sorted.touching), stdx::hmax(deepest)};
}

[[gnu::flatten]] void lubricate_far(const FarTask& task) {
  for (std::size_t from = 0; from < task.count; from += lanes) {
    const Batch batch = take(nullptr, from, task.count);
    lubricate_batch(task.particles, task.lubrication,
                    pair_geometry(task.particles, task.first, task.second, batch), batch.used);
  }
}

template <ContactTerms terms>
[[gnu::flatten]] ContactTally collide_planes(const PlaneTask& task) {
  const ParticlePointers& p = task.particles;
  Sorted sorted;
  const auto height = [&](const Batch& batch, int* i) {
    for (int k = 0; k < lanes; ++k) i[k] = task.particle[batch.slot[k]];
    const Vector<Lanes> normal = load(task.nx, task.ny, task.nz, batch.slot);
    return dot(normal, load(p.x, p.y, p.z, i)) - load(task.offset, batch.slot);
  };
  int i[lanes] = {};
  for (std::size_t from = 0; from < task.count; from += lanes) {
    const Batch batch = take(nullptr, from, task.count);
    const Lanes gap = height(batch, i) - load(p.radius, i);
    for (int k = 0; k < batch.used; ++k)
      sort_entry(gap[k], from + k, task.lubrication, task.springs, task.touching, task.lubricated,
                 sorted);
  }
  Lanes deepest(0.0);
  for (std::size_t from = 0; from < sorted.touching; from += lanes) {
    const Batch batch = take(task.touching, from, sorted.touching);
    const Lanes distance = height(batch, i);
    const Lanes radius = load(p.radius, i);
    ContactGeometry<Lanes> contact;
    contact.normal = load(task.nx, task.ny, task.nz, batch.slot);
    contact.overlap = radius - distance;
    contact.radius = radius;
    contact.mass = load(p.mass, i);
    contact.arm_i = radius - Lanes(0.5) * contact.overlap;
    contact.arm_j = Lanes(0.0);
    const Vector<Lanes> still{Lanes(0.0), Lanes(0.0), Lanes(0.0)};
    const ContactMotion<Lanes> motion{load(p.vx, p.vy, p.vz, i), load(p.wx, p.wy, p.wz, i), still};
    Springs<Lanes> springs = load_springs<terms>(task.springs, batch.slot);
    const ContactLoads<Lanes> loads =
        contact_loads<terms>(task.law, contact, motion, task.dt, springs);
    store_springs<terms>(task.springs, batch, springs);
    add(p.fx, p.fy, p.fz, i, loads.force, batch.used);
    if constexpr (terms.sliding || terms.rolling || terms.torsion)
      add(p.tx, p.ty, p.tz, i, loads.torque_i, batch.used);
    deepest = max(deepest, contact.overlap);
  }
  for (std::size_t from = 0; from < sorted.lubricated; from += lanes) {
    const Batch batch = take(task.lubricated, from, sorted.lubricated);
    const Lanes distance = height(batch, i);
    const Lanes radius = load(p.radius, i);
    const Lanes film = max(distance - radius, Lanes(task.lubrication.nearest));
    const Vector<Lanes> normal = load(task.nx, task.ny, task.nz, batch.slot);
    const Lanes coefficient = lubrication_coefficient(task.lubrication.viscosity, radius, film);
    const Lanes speed = dot(normal, load(p.vx, p.vy, p.vz, i));
    add(p.fx, p.fy, p.fz, i, (-(coefficient * speed)) * normal, batch.used);
  }
  return {static_cast<std::int64_t>(sorted.touching), stdx::hmax(deepest)};
}

/// Reads or writes a stretch of an array that may end before the vector does.
Lanes load_part(const double* values, int used) {
  if (used == lanes) return Lanes(values, stdx::element_aligned);
  return Lanes([&](auto k) { return values[static_cast<int>(k) < used ? static_cast<int>(k) : used - 1]; });
}

void store_part(double* values, Lanes amount, int used) {
  if (used == lanes) {
    amount.copy_to(values, stdx::element_aligned);
  } else {
    for (int k = 0; k < used; ++k) values[k] = amount[k];
  }
}

[[gnu::flatten]] AdvanceTally advance(const AdvanceTask& task) {
  const ParticlePointers& p = task.particles;
  const Lanes kick(task.kick), drift(task.drift), half(0.5);
  Lanes fastest(0.0), drag_work(0.0), body_work(0.0);
  for (std::size_t from = 0; from < p.count; from += lanes) {
    const std::size_t left = p.count - from;
    const int used = left < static_cast<std::size_t>(lanes) ? static_cast<int>(left) : lanes;
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
    // Not max(): a NaN must survive the reduction.
    fastest = select(speed2 <= fastest, fastest, speed2);
  }
  double largest = 0;
  for (int k = 0; k < lanes; ++k)
    if (!(fastest[k] <= largest)) largest = fastest[k];
  return {__builtin_sqrt(largest), stdx::reduce(drag_work), stdx::reduce(body_work)};
}

ContactTally pick_pairs(const PairTask& task, ContactTerms terms) {
  const int key = terms.sliding + 2 * terms.rolling + 4 * terms.torsion;
  switch (key) {
    case 0: return collide_pairs<ContactTerms{false, false, false}>(task);
    case 1: return collide_pairs<ContactTerms{true, false, false}>(task);
    case 2: return collide_pairs<ContactTerms{false, true, false}>(task);
    case 3: return collide_pairs<ContactTerms{true, true, false}>(task);
    case 4: return collide_pairs<ContactTerms{false, false, true}>(task);
    case 5: return collide_pairs<ContactTerms{true, false, true}>(task);
    case 6: return collide_pairs<ContactTerms{false, true, true}>(task);
    default: return collide_pairs<ContactTerms{true, true, true}>(task);
  }
}

ContactTally pick_planes(const PlaneTask& task, ContactTerms terms) {
  const int key = terms.sliding + 2 * terms.rolling + 4 * terms.torsion;
  switch (key) {
    case 0: return collide_planes<ContactTerms{false, false, false}>(task);
    case 1: return collide_planes<ContactTerms{true, false, false}>(task);
    case 2: return collide_planes<ContactTerms{false, true, false}>(task);
    case 3: return collide_planes<ContactTerms{true, true, false}>(task);
    case 4: return collide_planes<ContactTerms{false, false, true}>(task);
    case 5: return collide_planes<ContactTerms{true, false, true}>(task);
    case 6: return collide_planes<ContactTerms{false, true, true}>(task);
    default: return collide_planes<ContactTerms{true, true, true}>(task);
  }
}

constexpr Kernels make_kernels(const char* name) {
  return {name, lanes, pick_pairs, lubricate_far, pick_planes, advance};
}

}  // namespace
}  // namespace clog
