// The table of one instruction set. Included once per instruction set.
#pragma once

#include "dem/kernels/advance.hpp"
#include "dem/kernels/flow.hpp"
#include "dem/kernels/pairs.hpp"
#include "dem/kernels/planes.hpp"
#include "dem/physics/contact_laws.hpp"

namespace clogflow {
namespace {

constexpr ContactTerms all_terms{true, true, true};

/// The loop of one set of terms: bit 0 of `key` sliding, bit 1 rolling, bit 2 torsion.
template <int key, class Loop>
ContactTally loop_of(const Loop& loop) {
  return loop.template operator()<ContactTerms{(key & 1) != 0, (key & 2) != 0, (key & 4) != 0}>();
}

/// Calls the loop that is compiled for these terms.
template <Loops loops, class Loop>
ContactTally pick(ContactTerms terms, const Loop& loop) {
  if constexpr (loops == Loops::single) {
    return loop_of<7>(loop);
  } else {
    constexpr ContactTally (*all[])(const Loop&) = {loop_of<0, Loop>, loop_of<1, Loop>, loop_of<2, Loop>,
                                                    loop_of<3, Loop>, loop_of<4, Loop>, loop_of<5, Loop>,
                                                    loop_of<6, Loop>, loop_of<7, Loop>};
    return all[terms.sliding + 2 * terms.rolling + 4 * terms.torsion](loop);
  }
}

/// Where species have frictions of their own, there is one loop a law, for all sizes and terms.
template <class Kind>
ContactTally pick_pairs(const PairTask& task, ContactTerms terms) {
  if (task.law.friction.of_species) return collide_pairs<Kind, all_terms, false, FrictionOfSpecies>(task);
  return pick<Kind::loops>(terms, [&]<ContactTerms t>() {
    if constexpr (Kind::loops == Loops::tailored)
      if (task.radius > 0) return collide_pairs<Kind, t, true, CommonFriction>(task);
    return collide_pairs<Kind, t, false, CommonFriction>(task);
  });
}

template <class Kind>
ContactTally pick_planes(const PlaneTask& task, ContactTerms terms) {
  if (task.law.friction.of_species) return collide_planes<Kind, all_terms, FrictionOfSpecies>(task);
  return pick<Kind::loops>(terms, [&]<ContactTerms t>() { return collide_planes<Kind, t, CommonFriction>(task); });
}

/// One loop for every row of the registry, in its order.
template <class... Kinds>
ContactTally collide_pairs_of(KindList<Kinds...>, const PairTask& task, ContactTerms terms) {
  constexpr ContactTally (*loops[])(const PairTask&, ContactTerms) = {pick_pairs<Kinds>...};
  return loops[task.law.row->number](task, terms);
}

template <class... Kinds>
ContactTally collide_planes_of(KindList<Kinds...>, const PlaneTask& task, ContactTerms terms) {
  constexpr ContactTally (*loops[])(const PlaneTask&, ContactTerms) = {pick_planes<Kinds>...};
  return loops[task.law.row->number](task, terms);
}

ContactTally any_pairs(const PairTask& task, ContactTerms terms) {
  return collide_pairs_of(ContactKinds{}, task, terms);
}

ContactTally any_planes(const PlaneTask& task, ContactTerms terms) {
  return collide_planes_of(ContactKinds{}, task, terms);
}

constexpr Kernels make_kernels(const char* name) {
  return {name, lanes, any_pairs, any_planes, sample_nearest, advance};
}

}  // namespace
}  // namespace clogflow
