// Contacts and lubrication of particles with the inside of plane walls.
#pragma once

#include "dem/kernels/contact_rows.hpp"

namespace clogflow {
namespace {

/// Particles over their planes.
struct OverPlane {
  Lanes radius;
  Vector<Lanes> normal;
  Lanes x;        ///< of the centre [m]
  Lanes overlap;  ///< above zero where the sphere touches [m]

  OverPlane(const PlaneTask& task, Index i, Index slot)
      : normal{load(task.nx, slot), load(task.ny, slot), load(task.nz, slot)} {
    const Placed particle = load_place(task.particles, i);
    radius = particle.radius;
    x = particle.position.x;
    overlap = radius - (dot(normal, particle.position) - load(task.offset, slot));
  }
};

template <class Kind, ContactTerms terms, class Coefficients>
Contacts collide_plane(const PlaneTask& task, const typename Kind::Normal& law, std::size_t from, int used) {
  const ParticlePointers& p = task.particles;
  const Index i = task.contacts.touching.first + from;
  prefetch(p, i + vectors_ahead * lanes);
  const OverPlane over(task, i, task.contacts.touching.second + from);
  const Moving m = load_motion(p, i);
  const Lanes least = least_overlap(law, over.radius);
  const ContactGeometry<Lanes> contact = wall_contact(over.normal, max(over.overlap, least), over.radius, m.mass);
  const Vector<Lanes> still{Lanes(0.0), Lanes(0.0), Lanes(0.0)};
  const ContactMotion<Lanes> motion{m.velocity, load_spin(p, i), still};
  Springs<Lanes> springs = load_springs<terms>(task.contacts, from);
  const ContactLoads<Lanes> loads = contact_loads<typename Kind::Turning, terms>(
      law, Coefficients::of(task.law.friction, p, i, nullptr), contact, motion, task.dt, springs,
      rough_share(task.law.friction, [&] { return over.x; }));
  store_springs<terms>(task.contacts, from, springs);
  add_force(p, i, loads.force, used);
  if constexpr (terms.sliding || terms.rolling || terms.torsion) add_torque(p, i, loads.torque_i, used);
  return {over.overlap, over.overlap <= least};
}

void lubricate_plane(const PlaneTask& task, Index i, Index slot, int used) {
  const LubricationLaw& law = task.lubrication;
  const OverPlane over(task, i, slot);
  const Lanes gap = -over.overlap;
  const Lanes coefficient = film_coefficient(law, over.radius, gap, Lanes(1.0));
  const Lanes speed = dot(over.normal, load_motion(task.particles, i).velocity);
  add_force(task.particles, i, (-(coefficient * speed)) * over.normal, used);
}

template <class Kind, ContactTerms terms, class Coefficients>
[[gnu::flatten]] ContactTally collide_planes(const PlaneTask& given) {
  // Copies of its own: nothing that the loops write can change them, so their constants stay in
  // registers.
  const PlaneTask task = given;
  const auto law = task.law.constants.as<typename Kind::Normal>();
  const ContactPointers& c = task.contacts;
  begin_contacts(
      c, [&](Index i, Index slot) { return -OverPlane(task, i, slot).overlap; },
      [&](std::size_t row) { prefetch(task.particles, c.watched.first + row, 1); });
  Lanes deepest(0.0);
  Changes ended{c.changed};
  for_vectors(*c.touching.count, [&](std::size_t from, int used) {
    const Contacts contacts = collide_plane<Kind, terms, Coefficients>(task, law, from, used);
    ended.note(contacts.ended, from, used);
    deepest = max(deepest, used_lanes(contacts.overlap, used));
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
}  // namespace clogflow
