// Which candidates touch, which lubricate; the set of contacts follows.
#pragma once

#include "dem/kernels/lanes.hpp"

namespace clog {
namespace {

void begin_contact(const ContactPointers& contacts, std::size_t candidate) {
  const std::size_t at = (*contacts.count)++;
  contacts.position[candidate] = static_cast<int>(at);
  contacts.candidate[at] = static_cast<int>(candidate);
  for (double* spring : contacts.spring) spring[at] = 0;
}

void end_contact(const ContactPointers& contacts, std::size_t candidate) {
  const int at = contacts.position[candidate];
  const std::size_t last = --(*contacts.count);
  contacts.position[candidate] = -1;
  if (static_cast<std::size_t>(at) == last) return;
  for (double* spring : contacts.spring) spring[at] = spring[last];
  contacts.candidate[at] = contacts.candidate[last];
  contacts.position[contacts.candidate[at]] = at;
}

struct Sorter {
  ContactPointers contacts;
  LubricationLaw law;
  int* lubricated;
  std::size_t lubricated_count = 0;

  void sort(std::size_t candidate, double gap) {
    const bool touches = gap < 0;
    if (touches != (contacts.position[candidate] >= 0)) {
      if (touches) {
        begin_contact(contacts, candidate);
      } else {
        end_contact(contacts, candidate);
      }
    }
    // Without lubrication `farthest` is 0, and a candidate in reach never has a gap of exactly 0 twice.
    const bool films = !touches && gap <= law.farthest && (law.clamp || gap >= law.nearest);
    lubricated[lubricated_count] = static_cast<int>(candidate);
    lubricated_count += films && law.viscosity > 0;
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
