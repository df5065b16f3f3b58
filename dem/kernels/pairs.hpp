// Contacts and lubrication between particles.
#pragma once

#include "dem/kernels/sorting.hpp"
#include "dem/physics/lubrication.hpp"

namespace clog {
namespace {

/// The particles of a vector's worth of pairs.
struct PairLanes {
  int i[lanes], j[lanes];

  /// Pairs `list[from]` ...; without a list the pairs from, from + 1 ... Spare lanes repeat the last.
  PairLanes(const int* first, const int* second, const int* list, std::size_t from, int used) {
    for (int k = 0; k < lanes; ++k) {
      const std::size_t at = from + (k < used ? k : used - 1);
      const std::size_t pair = list ? list[at] : at;
      i[k] = first[pair];
      j[k] = second[pair];
    }
  }
};

/// Film between spheres: -c (n . v) n, with c / distance^2 in one division.
void lubricate(const ParticlePointers& p, const LubricationLaw& law, const PairLanes& pair, int used) {
  const Placed a = load_place(p, pair.i), b = load_place(p, pair.j);
  const Vector<Lanes> apart = a.position - b.position;
  const Lanes distance2 = dot(apart, apart);
  const Lanes gap = sqrt(distance2) - a.radius - b.radius;
  const Lanes film = max(gap, Lanes(law.nearest));
  const Lanes radius = a.radius * b.radius / (a.radius + b.radius);
  const Lanes coefficient =
      select(gap <= Lanes(law.farthest),
             lubrication_coefficient(law.viscosity, radius, film * distance2), Lanes(0.0));
  const Vector<Lanes> velocity = load_motion(p, pair.i).velocity - load_motion(p, pair.j).velocity;
  const Vector<Lanes> force = (-(coefficient * dot(velocity, apart))) * apart;
  add_force(p, pair.i, force, used);
  add_force(p, pair.j, -force, used);
}

[[gnu::flatten]] void lubricate_far(const FarTask& task) {
  for (std::size_t from = 0; from < task.count; from += lanes) {
    const int used = lanes_left(from, task.count);
    lubricate(task.particles, task.lubrication,
              PairLanes(task.first, task.second, nullptr, from, used), used);
  }
}

void sort_pairs(const PairTask& task, Sorter& sorter) {
  for (std::size_t from = 0; from < task.count; from += lanes) {
    const int used = lanes_left(from, task.count);
    const PairLanes pair(task.first, task.second, nullptr, from, used);
    const Placed a = load_place(task.particles, pair.i), b = load_place(task.particles, pair.j);
    const Vector<Lanes> apart = a.position - b.position;
    const Lanes gap = sqrt(dot(apart, apart)) - a.radius - b.radius;
    for (int k = 0; k < used; ++k) sorter.sort(from + k, gap[k]);
  }
}

template <ContactTerms terms>
Lanes collide(const PairTask& task, std::size_t from, int used) {
  const ParticlePointers& p = task.particles;
  const PairLanes pair(task.first, task.second, task.contacts.candidate, from, used);
  const Placed a = load_place(p, pair.i), b = load_place(p, pair.j);
  const Vector<Lanes> apart = a.position - b.position;
  const Lanes distance = sqrt(dot(apart, apart));
  const Moving ma = load_motion(p, pair.i), mb = load_motion(p, pair.j);
  ContactGeometry<Lanes> contact;
  contact.normal = (Lanes(1.0) / distance) * apart;
  contact.overlap = a.radius + b.radius - distance;
  contact.radius = a.radius * b.radius / (a.radius + b.radius);
  contact.mass = ma.mass * mb.mass / (ma.mass + mb.mass);
  contact.arm_i = a.radius - Lanes(0.5) * contact.overlap;
  contact.arm_j = b.radius - Lanes(0.5) * contact.overlap;
  const ContactMotion<Lanes> motion{ma.velocity - mb.velocity, load_spin(p, pair.i),
                                    load_spin(p, pair.j)};
  Springs<Lanes> springs = load_springs<terms>(task.contacts, from);
  const ContactLoads<Lanes> loads = contact_loads<terms>(task.law, contact, motion, task.dt, springs);
  store_springs<terms>(task.contacts, from, springs);
  add_force(p, pair.i, loads.force, used);
  add_force(p, pair.j, -loads.force, used);
  if constexpr (terms.sliding || terms.rolling || terms.torsion) {
    add_torque(p, pair.i, loads.torque_i, used);
    add_torque(p, pair.j, loads.torque_j, used);
  }
  return contact.overlap;
}

template <ContactTerms terms>
[[gnu::flatten]] ContactTally collide_pairs(const PairTask& task) {
  Sorter sorter{task.contacts, task.lubrication, task.lubricated};
  sort_pairs(task, sorter);
  const std::size_t count = *task.contacts.count;
  Lanes deepest(0.0);
  for (std::size_t from = 0; from < count; from += lanes)
    deepest = max(deepest, collide<terms>(task, from, lanes_left(from, count)));
  for (std::size_t from = 0; from < sorter.lubricated_count; from += lanes) {
    const int used = lanes_left(from, sorter.lubricated_count);
    lubricate(task.particles, task.lubrication,
              PairLanes(task.first, task.second, task.lubricated, from, used), used);
  }
  return {static_cast<std::int64_t>(count), stdx::hmax(deepest)};
}

}  // namespace
}  // namespace clog
