// Contacts and lubrication of particles with the inside of plane walls.
#pragma once

#include "dem/kernels/sorting.hpp"
#include "dem/physics/lubrication.hpp"

namespace clog {
namespace {

/// Particles over their planes.
struct OverPlane {
  Placed particle;
  Vector<Lanes> normal;
  Lanes height;  // of the centre over the plane [m]

  OverPlane(const PlaneTask& task, Index i, Index slot)
      : particle(load_place(task.particles, i)),
        normal{load(task.nx, slot), load(task.ny, slot), load(task.nz, slot)},
        height(dot(normal, particle.position) - load(task.offset, slot)) {}
};

template <ContactTerms terms>
Lanes collide_plane(const PlaneTask& task, std::size_t from, int used) {
  const ParticlePointers& p = task.particles;
  const Index i = task.contacts.first + from;
  const OverPlane over(task, i, task.contacts.second + from);
  const Moving m = load_motion(p, i);
  const Lanes radius = over.particle.radius;
  ContactGeometry<Lanes> contact;
  contact.normal = over.normal;
  contact.overlap = radius - over.height;
  contact.radius = radius;
  contact.mass = m.mass;
  contact.arm_i = radius - Lanes(0.5) * contact.overlap;
  contact.arm_j = Lanes(0.0);
  const Vector<Lanes> still{Lanes(0.0), Lanes(0.0), Lanes(0.0)};
  const ContactMotion<Lanes> motion{m.velocity, load_spin(p, i), still};
  Springs<Lanes> springs = load_springs<terms>(task.contacts, from);
  const ContactLoads<Lanes> loads = contact_loads<terms>(task.law, contact, motion, task.dt, springs);
  store_springs<terms>(task.contacts, from, springs);
  add_force(p, i, loads.force, used);
  if constexpr (terms.sliding || terms.rolling || terms.torsion)
    add_torque(p, i, loads.torque_i, used);
  return used_lanes(contact.overlap, used);
}

void lubricate_plane(const PlaneTask& task, Index i, Index slot, int used) {
  const OverPlane over(task, i, slot);
  const Lanes film = max(over.height - over.particle.radius, Lanes(task.lubrication.nearest));
  const Lanes coefficient =
      lubrication_coefficient(task.lubrication.viscosity, over.particle.radius, film);
  const Lanes speed = dot(over.normal, load_motion(task.particles, i).velocity);
  add_force(task.particles, i, (-(coefficient * speed)) * over.normal, used);
}

template <ContactTerms terms>
[[gnu::flatten]] ContactTally collide_planes(const PlaneTask& task) {
  Sorter sorter{task.contacts, task.lubrication, task.film_first, task.film_second};
  for (std::size_t from = 0; from < task.count; from += lanes) {
    const Index i = task.particle + from, slot = task.slot + from;
    const OverPlane over(task, i, slot);
    sorter.sort(over.height - over.particle.radius, from, i, slot, lanes_left(from, task.count));
  }
  const std::size_t count = *task.contacts.count;
  Lanes deepest(0.0);
  for (std::size_t from = 0; from < count; from += lanes)
    deepest = max(deepest, collide_plane<terms>(task, from, lanes_left(from, count)));
  for (std::size_t from = 0; from < sorter.films; from += lanes)
    lubricate_plane(task, task.film_first + from, task.film_second + from,
                    lanes_left(from, sorter.films));
  return {static_cast<std::int64_t>(count), stdx::hmax(deepest)};
}

}  // namespace
}  // namespace clog
