// Contacts and lubrication of particles with the inside of plane walls.
#pragma once

#include "dem/kernels/sorting.hpp"
#include "dem/physics/lubrication.hpp"

namespace clog {
namespace {

/// The particles of a vector's worth of candidates, and their planes.
struct PlaneLanes {
  int slot[lanes], i[lanes];
  Vector<Lanes> normal;

  PlaneLanes(const PlaneTask& task, const int* list, std::size_t from, int used) {
    for (int k = 0; k < lanes; ++k) {
      const std::size_t at = from + (k < used ? k : used - 1);
      slot[k] = list ? list[at] : static_cast<int>(at);
      i[k] = task.particle[slot[k]];
    }
    normal = {load(task.nx, slot), load(task.ny, slot), load(task.nz, slot)};
  }

  /// Height of a particle's centre over its plane [m].
  Lanes height(const PlaneTask& task, const Placed& a) const {
    return dot(normal, a.position) - load(task.offset, slot);
  }
};

template <ContactTerms terms>
Lanes collide_plane(const PlaneTask& task, std::size_t from, int used) {
  const ParticlePointers& p = task.particles;
  const PlaneLanes plane(task, task.contacts.candidate, from, used);
  const Placed a = load_place(p, plane.i);
  const Moving m = load_motion(p, plane.i);
  ContactGeometry<Lanes> contact;
  contact.normal = plane.normal;
  contact.overlap = a.radius - plane.height(task, a);
  contact.radius = a.radius;
  contact.mass = m.mass;
  contact.arm_i = a.radius - Lanes(0.5) * contact.overlap;
  contact.arm_j = Lanes(0.0);
  const Vector<Lanes> still{Lanes(0.0), Lanes(0.0), Lanes(0.0)};
  const ContactMotion<Lanes> motion{m.velocity, load_spin(p, plane.i), still};
  Springs<Lanes> springs = load_springs<terms>(task.contacts, from);
  const ContactLoads<Lanes> loads = contact_loads<terms>(task.law, contact, motion, task.dt, springs);
  store_springs<terms>(task.contacts, from, springs);
  add_force(p, plane.i, loads.force, used);
  if constexpr (terms.sliding || terms.rolling || terms.torsion)
    add_torque(p, plane.i, loads.torque_i, used);
  return contact.overlap;
}

void lubricate_plane(const PlaneTask& task, const PlaneLanes& plane, int used) {
  const ParticlePointers& p = task.particles;
  const Placed a = load_place(p, plane.i);
  const Lanes film = max(plane.height(task, a) - a.radius, Lanes(task.lubrication.nearest));
  const Lanes coefficient = lubrication_coefficient(task.lubrication.viscosity, a.radius, film);
  const Lanes speed = dot(plane.normal, load_motion(p, plane.i).velocity);
  add_force(p, plane.i, (-(coefficient * speed)) * plane.normal, used);
}

template <ContactTerms terms>
[[gnu::flatten]] ContactTally collide_planes(const PlaneTask& task) {
  Sorter sorter{task.contacts, task.lubrication, task.lubricated};
  for (std::size_t from = 0; from < task.count; from += lanes) {
    const int used = lanes_left(from, task.count);
    const PlaneLanes plane(task, nullptr, from, used);
    const Placed a = load_place(task.particles, plane.i);
    const Lanes gap = plane.height(task, a) - a.radius;
    for (int k = 0; k < used; ++k) sorter.sort(from + k, gap[k]);
  }
  const std::size_t count = *task.contacts.count;
  Lanes deepest(0.0);
  for (std::size_t from = 0; from < count; from += lanes)
    deepest = max(deepest, collide_plane<terms>(task, from, lanes_left(from, count)));
  for (std::size_t from = 0; from < sorter.lubricated_count; from += lanes) {
    const int used = lanes_left(from, sorter.lubricated_count);
    lubricate_plane(task, PlaneLanes(task, task.lubricated, from, used), used);
  }
  return {static_cast<std::int64_t>(count), stdx::hmax(deepest)};
}

}  // namespace
}  // namespace clog
