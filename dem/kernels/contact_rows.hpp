// The rows of touching and watched candidates: which begin to touch, which cease.
#pragma once

#include "dem/kernels/gather.hpp"

namespace clogflow {
namespace {

/// What a vector of contacts tells the lists.
struct Contacts {
  Lanes overlap;
  Lanes::mask_type ended;
};

/// Overlap at which a contact ends: 0, or a gap where spheres stick.
template <class Law>
Lanes least_overlap(const Law& law, const Lanes& radius) {
  if constexpr (Law::adheres) {
    return -law.reach(radius);
  } else {
    return Lanes(0.0);
  }
}

/// 1 where contacts have friction, 0 where it has ended. \param x  gives the places of the contacts
template <class Place>
Lanes rough_share(const FrictionLaw& friction, const Place& x) {
  if (!friction.ends_somewhere()) return Lanes(1.0);
  return select(x() > Lanes(friction.ends), Lanes(0.0), Lanes(1.0));
}

/// The coefficients where all contacts have the same.
struct CommonFriction {
  static const FrictionLaw& of(const FrictionLaw& law, const ParticlePointers&, Index, Index) { return law; }
};

/// The coefficients where they depend on the species. \param j  nullptr for walls
struct FrictionOfSpecies {
  static ContactFriction<Lanes> of(const FrictionLaw& law, const ParticlePointers& p, Index i, Index j) {
    int row[lanes];
    for (int k = 0; k < lanes; ++k) row[k] = p.species[i[k]] * law.partners + (j ? p.species[j[k]] : 0);
    const Columns c = load_records(law.of_species, friction_row, row);
    return {c.c[0], c.c[1], c.c[2]};
  }
};

/// Appends a row of one list to another; the last row takes its place.
void move_row(const RowPointers& from, std::size_t at, const RowPointers& to) {
  const std::size_t last = --(*from.count), end = (*to.count)++;
  to.first[end] = from.first[at], from.first[at] = from.first[last];
  to.second[end] = from.second[at], from.second[at] = from.second[last];
  to.candidate[end] = from.candidate[at], from.candidate[at] = from.candidate[last];
}

/// Rows to be moved. Moved from the last to the first, so that what takes a row's place has been
/// seen.
struct Changes {
  int* rows;
  std::size_t count = 0;

  void note(const Lanes::mask_type& changed, std::size_t from, int used) {
    if (!stdx::any_of(changed)) return;
    for (int k = 0; k < used; ++k)
      if (changed[k]) rows[count++] = static_cast<int>(from) + k;
  }
};

/// Watched candidates whose gap is below zero become contacts with springs of length zero.
/// \param gap    of the rows first + k, second + k
/// \param ahead  asks for what gap() will need of a row and the next ones
template <class Gap, class Ahead>
void begin_contacts(const ContactPointers& c, const Gap& gap, const Ahead& ahead) {
  Changes changes{c.changed};
  const std::size_t count = *c.watched.count;
  for (std::size_t from = 0; from < count; from += lanes) {
    ahead(from + vectors_ahead * lanes);
    changes.note(gap(c.watched.first + from, c.watched.second + from) < Lanes(0.0), from, lanes_left(from, count));
  }
  while (changes.count > 0) {
    const std::size_t at = *c.touching.count;
    for (int part = 0; part < 7; ++part) spring_part(c.springs, part, at) = 0;
    move_row(c.watched, changes.rows[--changes.count], c.touching);
  }
}

void end_contacts(const ContactPointers& c, Changes& changes) {
  while (changes.count > 0) {
    const std::size_t at = changes.rows[--changes.count], last = *c.touching.count - 1;
    for (int part = 0; part < 7; ++part) spring_part(c.springs, part, at) = spring_part(c.springs, part, last);
    move_row(c.touching, at, c.watched);
  }
}

template <ContactTerms terms>
Springs<Lanes> load_springs(const ContactPointers& s, std::size_t from) {
  const Lanes zero(0.0);
  const auto read = [&](int c) { return load_lanes(&spring_part(s.springs, c, from)); };
  Springs<Lanes> springs{{zero, zero, zero}, {zero, zero, zero}, zero};
  if constexpr (terms.sliding) springs.sliding = {read(0), read(1), read(2)};
  if constexpr (terms.rolling) springs.rolling = {read(3), read(4), read(5)};
  if constexpr (terms.torsion) springs.torsion = read(6);
  return springs;
}

/// Whole vectors: the arrays are padded, and a contact that begins sets its springs to zero.
template <ContactTerms terms>
void store_springs(const ContactPointers& s, std::size_t from, const Springs<Lanes>& springs) {
  const auto write = [&](int c, const Lanes& v) { store_lanes(&spring_part(s.springs, c, from), v); };
  if constexpr (terms.sliding) write(0, springs.sliding.x), write(1, springs.sliding.y), write(2, springs.sliding.z);
  if constexpr (terms.rolling) write(3, springs.rolling.x), write(4, springs.rolling.y), write(5, springs.rolling.z);
  if constexpr (terms.torsion) write(6, springs.torsion);
}

/// Calls each(from, used) for every vector of `count` rows.
template <class Each>
void for_vectors(std::size_t count, const Each& each) {
  for (std::size_t from = 0; from < count; from += lanes) each(from, lanes_left(from, count));
}

}  // namespace
}  // namespace clogflow
