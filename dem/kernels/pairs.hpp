// Contacts and lubrication between particles.
#pragma once

#include "dem/kernels/contact_rows.hpp"

namespace clogflow {
namespace {

/// Places of pairs and their sizes. Equal spheres need one transposition instead of two, and all
/// that depends on sizes alone is the same for every vector.
template <bool equal>
PairPlace<Lanes> load_pair_place(const PairTask& task, Index i, Index j) {
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
    return {a.velocity - b.velocity, reduced(a.mass, b.mass)};
  }
}

/// How far the two of each lane are apart. One expression for all who ask, so that they agree to the bit.
struct Meeting {
  PairPlace<Lanes> place;
  Lanes distance2, per_distance;

  Lanes distance() const { return distance2 * per_distance; }
  Lanes overlap() const { return place.overlap(distance()); }
};

template <bool equal>
Meeting meet(const PairTask& task, Index i, Index j) {
  const PairPlace<Lanes> place = load_pair_place<equal>(task, i, j);
  const Lanes distance2 = place.distance2();
  return {place, distance2, inverse_root(distance2)};
}

[[gnu::always_inline]] inline void prefetch_pairs(const PairTask& task, Index i, Index j) {
  prefetch(task.particles, i + vectors_ahead * lanes);
  prefetch(task.particles, j + vectors_ahead * lanes);
}

/// Film between spheres: -c (n . v) n, with c / distance^2 in one division.
template <bool equal>
void lubricate(const PairTask& task, Index i, Index j, int used) {
  prefetch_pairs(task, i, j);
  const Meeting m = meet<equal>(task, i, j);
  const Lanes coefficient = film_coefficient(task.lubrication, m.place.effective_radius(), -m.overlap(), m.distance2);
  const Vector<Lanes> velocity = load_pair_motion<equal>(task, i, j).velocity;
  add_force(task.particles, i, j, (-(coefficient * dot(velocity, m.place.apart))) * m.place.apart, used);
}

template <class Kind, ContactTerms terms, bool equal, class Coefficients>
Contacts collide(const PairTask& task, const typename Kind::Normal& law, const Meeting& m, std::size_t from, int used) {
  const ParticlePointers& p = task.particles;
  const Index i = task.contacts.touching.first + from, j = task.contacts.touching.second + from;
  const Lanes overlap = m.overlap();
  const Lanes least = least_overlap(law, m.place.effective_radius());
  const PairMotion moves = load_pair_motion<equal>(task, i, j);
  ContactGeometry<Lanes> contact = m.place.contact(m.per_distance * m.place.apart, max(overlap, least), moves.mass);
  constexpr ContactTerms now{terms.sliding, terms.rolling, terms.torsion, !equal};
  if constexpr (now.midway) contact.turning = task.radius > 0 ? Lanes(0.0) : m.per_distance;
  const ContactMotion<Lanes> motion{moves.velocity, load_spin(p, i), load_spin(p, j)};
  Springs<Lanes> springs = load_springs<terms>(task.contacts, from);
  const Lanes rough = rough_share(
      task.law.friction, [&] { return Lanes(0.5) * (load_place(p, i).position.x + load_place(p, j).position.x); });
  const ContactLoads<Lanes> loads = contact_loads<typename Kind::Turning, now>(
      law, Coefficients::of(task.law.friction, p, i, j), contact, motion, task.dt, springs, rough);
  store_springs<terms>(task.contacts, from, springs);
  add_force(p, i, j, loads.force, used);
  if constexpr (terms.sliding || terms.rolling || terms.torsion) {
    add_torque(p, i, loads.torque_i, used);
    add_torque(p, j, loads.torque_j, used);
  }
  return {overlap, overlap <= least};
}

/// Vectors that meet before the first of them collides. A collision is longer than what a processor keeps in view, so
/// that the wait for one's root would not be filled with the next one's work.
constexpr std::size_t met_together = 16;

template <class Kind, ContactTerms terms, bool equal, class Coefficients>
[[gnu::flatten]] ContactTally collide_pairs(const PairTask& given) {
  // Copies of its own: nothing that the loops write can change them, so their constants stay in
  // registers.
  const PairTask task = given;
  const auto law = task.law.constants.as<typename Kind::Normal>();
  const ContactPointers& c = task.contacts;
  begin_contacts(
      c, [&](Index i, Index j) { return -meet<equal>(task, i, j).overlap(); },
      [&](std::size_t row) {
        prefetch(task.particles, c.watched.first + row, 1);
        prefetch(task.particles, c.watched.second + row, 1);
      });
  Lanes deepest(0.0);
  Changes ended{c.changed};
  Meeting met[met_together];
  const std::size_t count = *c.touching.count;
  for (std::size_t begin = 0; begin < count; begin += met_together * lanes) {
    std::size_t ready = 0;
    for (std::size_t from = begin; from < count && ready < met_together; from += lanes) {
      const Index i = c.touching.first + from, j = c.touching.second + from;
      prefetch_pairs(task, i, j);
      met[ready++] = meet<equal>(task, i, j);
    }
    for (std::size_t k = 0; k < ready; ++k) {
      const std::size_t from = begin + k * lanes;
      const int used = lanes_left(from, count);
      const Contacts contacts = collide<Kind, terms, equal, Coefficients>(task, law, met[k], from, used);
      ended.note(contacts.ended, from, used);
      deepest = max(deepest, used_lanes(contacts.overlap, used));
    }
  }
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
}  // namespace clogflow
