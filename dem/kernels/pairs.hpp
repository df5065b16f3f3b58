// Contacts and lubrication between particles.
#pragma once

#include "dem/kernels/contact_rows.hpp"
#include "dem/physics/lubrication.hpp"

namespace clog {
namespace {

/// Places of pairs and their sizes. Equal spheres need one transposition instead of two, and all
/// that depends on sizes alone is the same for every vector.
struct PairPlace {
  Vector<Lanes> apart;
  Lanes radius_i, radius_j;

  /// Above zero where the spheres overlap. One expression for all who ask, so that they agree to
  /// the bit.
  Lanes overlap(const Lanes& distance) const { return radius_i + radius_j - distance; }
  Lanes effective_radius() const { return radius_i * radius_j / (radius_i + radius_j); }
};

template <bool equal>
PairPlace load_pair_place(const PairTask& task, Index i, Index j) {
  const ParticlePointers& p = task.particles;
  if constexpr (equal) {
    const Columns c = load_differences(p.state, record_stride, i, j);
    return {{c.c[0], c.c[1], c.c[2]}, Lanes(task.radius), Lanes(task.radius)};
  } else {
    const Placed a = load_place(p, i), b = load_place(p, j);
    return {a.position - b.position, a.radius, b.radius};
  }
}

struct PairMotion {
  Vector<Lanes> velocity;
  Lanes mass;  ///< effective
};

template <bool equal>
PairMotion load_pair_motion(const PairTask& task, Index i, Index j) {
  const ParticlePointers& p = task.particles;
  if constexpr (equal) {
    const Columns c = load_differences(p.state + 4, record_stride, i, j);
    return {{c.c[0], c.c[1], c.c[2]}, Lanes(0.5 * task.mass)};
  } else {
    const Moving a = load_motion(p, i), b = load_motion(p, j);
    return {a.velocity - b.velocity, a.mass * b.mass / (a.mass + b.mass)};
  }
}

/// Film between spheres: -c (n . v) n, with c / distance^2 in one division.
template <bool equal>
void lubricate(const PairTask& task, Index i, Index j, int used) {
  const LubricationLaw& law = task.lubrication;
  ask_for(task.particles, i + vectors_ahead * lanes);
  ask_for(task.particles, j + vectors_ahead * lanes);
  const PairPlace place = load_pair_place<equal>(task, i, j);
  const Lanes distance2 = dot(place.apart, place.apart);
  const Lanes gap = -place.overlap(sqrt(distance2));
  const Lanes film = max(gap, Lanes(law.nearest));
  const Lanes coefficient =
      select(gap <= Lanes(law.farthest) && gap >= Lanes(law.least()),
             lubrication_coefficient(law.viscosity, place.effective_radius(), film * distance2),
             Lanes(0.0));
  const Vector<Lanes> velocity = load_pair_motion<equal>(task, i, j).velocity;
  add_force(task.particles, i, j, (-(coefficient * dot(velocity, place.apart))) * place.apart,
            used);
}

/// \return the overlap, below zero where a contact has ended
template <ContactTerms terms, bool equal>
Lanes collide(const PairTask& task, std::size_t from, int used) {
  const ParticlePointers& p = task.particles;
  const Index i = task.contacts.touching.first + from, j = task.contacts.touching.second + from;
  ask_for(p, i + vectors_ahead * lanes);
  ask_for(p, j + vectors_ahead * lanes);
  const PairPlace place = load_pair_place<equal>(task, i, j);
  const Lanes distance = sqrt(dot(place.apart, place.apart));
  const Lanes overlap = place.overlap(distance);
  const PairMotion moves = load_pair_motion<equal>(task, i, j);
  ContactGeometry<Lanes> contact;
  contact.normal = (Lanes(1.0) / distance) * place.apart;
  contact.overlap = max(overlap, Lanes(0.0));
  contact.radius = place.effective_radius();
  contact.mass = moves.mass;
  contact.arm_i = place.radius_i - Lanes(0.5) * contact.overlap;
  contact.arm_j = place.radius_j - Lanes(0.5) * contact.overlap;
  const ContactMotion<Lanes> motion{moves.velocity, load_spin(p, i), load_spin(p, j)};
  Springs<Lanes> springs = load_springs<terms>(task.contacts, from);
  const ContactLoads<Lanes> loads =
      contact_loads<terms>(task.law, contact, motion, task.dt, springs);
  store_springs<terms>(task.contacts, from, springs);
  add_force(p, i, j, loads.force, used);
  if constexpr (terms.sliding || terms.rolling || terms.torsion) {
    add_torque(p, i, loads.torque_i, used);
    add_torque(p, j, loads.torque_j, used);
  }
  return overlap;
}

template <ContactTerms terms, bool equal>
[[gnu::flatten]] ContactTally collide_pairs(const PairTask& given) {
  // A copy of its own: nothing that the loops write can change it, so its constants stay in
  // registers.
  const PairTask task = given;
  const ContactPointers& c = task.contacts;
  begin_contacts(c, [&](Index i, Index j) {
    const PairPlace place = load_pair_place<equal>(task, i, j);
    return -place.overlap(sqrt(dot(place.apart, place.apart)));
  }, [&](std::size_t row) {
    ask_for(task.particles, c.watched.first + row, 1);
    ask_for(task.particles, c.watched.second + row, 1);
  });
  Lanes deepest(0.0);
  Changes ended{c.changed};
  for_vectors(*c.touching.count, [&](std::size_t from, int used) {
    const Lanes overlap = used_lanes(collide<terms, equal>(task, from, used), used);
    ended.note(overlap <= Lanes(0.0), from, used);
    deepest = max(deepest, overlap);
  });
  end_contacts(c, ended);
  if (task.lubrication.viscosity > 0) {
    for_vectors(c.film_count, [&](std::size_t from, int used) {
      lubricate<equal>(task, c.film_first + from, c.film_second + from, used);
    });
    if (c.watched_lubricate)
      for_vectors(*c.watched.count, [&](std::size_t from, int used) {
        lubricate<equal>(task, c.watched.first + from, c.watched.second + from, used);
      });
  }
  return {static_cast<std::int64_t>(*c.touching.count), stdx::hmax(deepest)};
}

}  // namespace
}  // namespace clog
