// Contacts and lubrication between particles.
#pragma once

#include "dem/kernels/sorting.hpp"
#include "dem/physics/lubrication.hpp"

namespace clog {
namespace {

/// Film between spheres: -c (n . v) n, with c / distance^2 in one division.
void lubricate(const ParticlePointers& p, const LubricationLaw& law, Index i, Index j, int used) {
  const Placed a = load_place(p, i), b = load_place(p, j);
  const Vector<Lanes> apart = a.position - b.position;
  const Lanes distance2 = dot(apart, apart);
  const Lanes gap = sqrt(distance2) - a.radius - b.radius;
  const Lanes film = max(gap, Lanes(law.nearest));
  const Lanes radius = a.radius * b.radius / (a.radius + b.radius);
  const Lanes coefficient =
      select(gap <= Lanes(law.farthest),
             lubrication_coefficient(law.viscosity, radius, film * distance2), Lanes(0.0));
  const Vector<Lanes> velocity = load_motion(p, i).velocity - load_motion(p, j).velocity;
  add_force(p, i, j, (-(coefficient * dot(velocity, apart))) * apart, used);
}

[[gnu::flatten]] void lubricate_far(const FarTask& task) {
  for (std::size_t from = 0; from < task.count; from += lanes)
    lubricate(task.particles, task.lubrication, task.first + from, task.second + from,
              lanes_left(from, task.count));
}

template <ContactTerms terms>
Lanes collide(const PairTask& task, std::size_t from, int used) {
  const ParticlePointers& p = task.particles;
  const Index i = task.contacts.first + from, j = task.contacts.second + from;
  const Placed a = load_place(p, i), b = load_place(p, j);
  const Vector<Lanes> apart = a.position - b.position;
  const Lanes distance = sqrt(dot(apart, apart));
  const Moving ma = load_motion(p, i), mb = load_motion(p, j);
  ContactGeometry<Lanes> contact;
  contact.normal = (Lanes(1.0) / distance) * apart;
  contact.overlap = a.radius + b.radius - distance;
  contact.radius = a.radius * b.radius / (a.radius + b.radius);
  contact.mass = ma.mass * mb.mass / (ma.mass + mb.mass);
  contact.arm_i = a.radius - Lanes(0.5) * contact.overlap;
  contact.arm_j = b.radius - Lanes(0.5) * contact.overlap;
  const ContactMotion<Lanes> motion{ma.velocity - mb.velocity, load_spin(p, i), load_spin(p, j)};
  Springs<Lanes> springs = load_springs<terms>(task.contacts, from);
  const ContactLoads<Lanes> loads = contact_loads<terms>(task.law, contact, motion, task.dt, springs);
  store_springs<terms>(task.contacts, from, springs);
  add_force(p, i, j, loads.force, used);
  if constexpr (terms.sliding || terms.rolling || terms.torsion) {
    add_torque(p, i, loads.torque_i, used);
    add_torque(p, j, loads.torque_j, used);
  }
  return used_lanes(contact.overlap, used);
}

template <ContactTerms terms>
[[gnu::flatten]] ContactTally collide_pairs(const PairTask& task) {
  Sorter sorter{task.contacts, task.lubrication, task.film_first, task.film_second};
  for (std::size_t from = 0; from < task.count; from += lanes) {
    const Index i = task.first + from, j = task.second + from;
    const Placed a = load_place(task.particles, i), b = load_place(task.particles, j);
    const Vector<Lanes> apart = a.position - b.position;
    sorter.sort(sqrt(dot(apart, apart)) - a.radius - b.radius, from, i, j,
                lanes_left(from, task.count));
  }
  const std::size_t count = *task.contacts.count;
  Lanes deepest(0.0);
  for (std::size_t from = 0; from < count; from += lanes)
    deepest = max(deepest, collide<terms>(task, from, lanes_left(from, count)));
  for (std::size_t from = 0; from < sorter.films; from += lanes)
    lubricate(task.particles, task.lubrication, task.film_first + from, task.film_second + from,
              lanes_left(from, sorter.films));
  return {static_cast<std::int64_t>(count), stdx::hmax(deepest)};
}

}  // namespace
}  // namespace clog
