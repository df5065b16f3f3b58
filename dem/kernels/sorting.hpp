// Which candidates touch, which lubricate; the set of contacts follows.
#pragma once

#include "dem/kernels/lanes.hpp"

namespace clog {
namespace {

void begin_contact(const ContactPointers& contacts, int candidate, int first, int second) {
  const std::size_t at = (*contacts.count)++;
  contacts.position[candidate] = static_cast<int>(at);
  contacts.candidate[at] = candidate;
  contacts.first[at] = first;
  contacts.second[at] = second;
  for (double* spring : contacts.spring) spring[at] = 0;
}

/// The last contact takes the place of the one that ends.
void end_contact(const ContactPointers& contacts, int candidate) {
  const int at = contacts.position[candidate];
  const std::size_t last = --(*contacts.count);
  contacts.position[candidate] = -1;
  if (static_cast<std::size_t>(at) == last) return;
  for (double* spring : contacts.spring) spring[at] = spring[last];
  for (int* indices : {contacts.candidate, contacts.first, contacts.second})
    indices[at] = indices[last];
  contacts.position[contacts.candidate[at]] = at;
}

/// Sorts candidates by their gap into touching, lubricated or neither.
struct Sorter {
  ContactPointers contacts;
  LubricationLaw law;
  int *film_first, *film_second;
  std::size_t films = 0;

  void sort(const Lanes& gap, std::size_t from, Index first, Index second, int used) {
    double gaps[lanes];
    gap.copy_to(gaps, stdx::element_aligned);
    for (int k = 0; k < used; ++k) {
      const int candidate = static_cast<int>(from) + k;
      const bool touches = gaps[k] < 0;
      if (touches != (contacts.position[candidate] >= 0)) {
        if (touches) {
          begin_contact(contacts, candidate, first[k], second[k]);
        } else {
          end_contact(contacts, candidate);
        }
      }
      if (law.viscosity > 0) {
        film_first[films] = first[k];
        film_second[films] = second[k];
        films += !touches && gaps[k] <= law.farthest && (law.clamp || gaps[k] >= law.nearest);
      }
    }
  }
};

template <ContactTerms terms>
Springs<Lanes> load_springs(const ContactPointers& s, std::size_t from) {
  const Lanes zero(0.0);
  const auto read = [&](int c) { return Lanes(s.spring[c] + from, stdx::element_aligned); };
  Springs<Lanes> springs{{zero, zero, zero}, {zero, zero, zero}, zero};
  if constexpr (terms.sliding) springs.sliding = {read(0), read(1), read(2)};
  if constexpr (terms.rolling) springs.rolling = {read(3), read(4), read(5)};
  if constexpr (terms.torsion) springs.torsion = read(6);
  return springs;
}

/// Whole vectors: the arrays are padded, and a contact that begins sets its springs to zero.
template <ContactTerms terms>
void store_springs(const ContactPointers& s, std::size_t from, const Springs<Lanes>& springs) {
  const auto write = [&](int c, const Lanes& v) { v.copy_to(s.spring[c] + from, stdx::element_aligned); };
  if constexpr (terms.sliding)
    write(0, springs.sliding.x), write(1, springs.sliding.y), write(2, springs.sliding.z);
  if constexpr (terms.rolling)
    write(3, springs.rolling.x), write(4, springs.rolling.y), write(5, springs.rolling.z);
  if constexpr (terms.torsion) write(6, springs.torsion);
}

}  // namespace
}  // namespace clog
