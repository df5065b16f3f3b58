// Contacts and lubrication of particles with the inside of plane walls.
#pragma once

#include "dem/kernels/contact_rows.hpp"
#include "dem/physics/lubrication.hpp"

namespace clog {
namespace {

/// Particles over their planes.
struct OverPlane {
  Lanes radius;
  Vector<Lanes> normal;
  Lanes overlap;  ///< above zero where the sphere touches [m]

  OverPlane(const PlaneTask& task, Index i, Index slot)
      : normal{load(task.nx, slot), load(task.ny, slot), load(task.nz, slot)} {
    const Placed particle = load_place(task.particles, i);
    radius = particle.radius;
    overlap = radius - (dot(normal, particle.position) - load(task.offset, slot));
  }
};

/// \return the overlap, below zero where a contact has ended
template <ContactTerms terms>
Lanes collide_plane(const PlaneTask& task, std::size_t from, int used) {
  const ParticlePointers& p = task.particles;
  const Index i = task.contacts.touching.first + from;
  ask_for(p, i + vectors_ahead * lanes);
  const OverPlane over(task, i, task.contacts.touching.second + from);
  const Moving m = load_motion(p, i);
  ContactGeometry<Lanes> contact;
  contact.normal = over.normal;
  contact.overlap = max(over.overlap, Lanes(0.0));
  contact.radius = over.radius;
  contact.mass = m.mass;
  contact.arm_i = over.radius - Lanes(0.5) * contact.overlap;
  contact.arm_j = Lanes(0.0);
  const Vector<Lanes> still{Lanes(0.0), Lanes(0.0), Lanes(0.0)};
  const ContactMotion<Lanes> motion{m.velocity, load_spin(p, i), still};
  Springs<Lanes> springs = load_springs<terms>(task.contacts, from);
  const ContactLoads<Lanes> loads =
      contact_loads<terms>(task.law, contact, motion, task.dt, springs);
  store_springs<terms>(task.contacts, from, springs);
  add_force(p, i, loads.force, used);
  if constexpr (terms.sliding || terms.rolling || terms.torsion)
    add_torque(p, i, loads.torque_i, used);
  return over.overlap;
}

void lubricate_plane(const PlaneTask& task, Index i, Index slot, int used) {
  const LubricationLaw& law = task.lubrication;
  const OverPlane over(task, i, slot);
  const Lanes gap = -over.overlap;
  const Lanes film = max(gap, Lanes(law.nearest));
  const Lanes coefficient =
      select(gap <= Lanes(law.farthest) && gap >= Lanes(law.least()),
             lubrication_coefficient(law.viscosity, over.radius, film), Lanes(0.0));
  const Lanes speed = dot(over.normal, load_motion(task.particles, i).velocity);
  add_force(task.particles, i, (-(coefficient * speed)) * over.normal, used);
}

template <ContactTerms terms>
[[gnu::flatten]] ContactTally collide_planes(const PlaneTask& given) {
  // A copy of its own: nothing that the loops write can change it, so its constants stay in
  // registers.
  const PlaneTask task = given;
  const ContactPointers& c = task.contacts;
  begin_contacts(
      c, [&](Index i, Index slot) { return -OverPlane(task, i, slot).overlap; },
      [&](std::size_t row) { ask_for(task.particles, c.watched.first + row, 1); });
  Lanes deepest(0.0);
  Changes ended{c.changed};
  for_vectors(*c.touching.count, [&](std::size_t from, int used) {
    const Lanes overlap = used_lanes(collide_plane<terms>(task, from, used), used);
    ended.note(overlap <= Lanes(0.0), from, used);
    deepest = max(deepest, overlap);
  });
  end_contacts(c, ended);
  if (task.lubrication.viscosity > 0) {
    for_vectors(c.film_count, [&](std::size_t from, int used) {
      lubricate_plane(task, c.film_first + from, c.film_second + from, used);
    });
    if (c.watched_lubricate)
      for_vectors(*c.watched.count, [&](std::size_t from, int used) {
        lubricate_plane(task, c.watched.first + from, c.watched.second + from, used);
      });
  }
  return {static_cast<std::int64_t>(*c.touching.count), stdx::hmax(deepest)};
}

}  // namespace
}  // namespace clog
