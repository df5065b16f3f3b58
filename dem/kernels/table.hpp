// The table of one instruction set. Included once per instruction set.
#pragma once

#include "dem/kernels/advance.hpp"
#include "dem/kernels/flow.hpp"
#include "dem/kernels/pairs.hpp"
#include "dem/kernels/planes.hpp"

namespace clog {
namespace {

/// Calls the loop that is compiled for these terms.
template <class Loop>
ContactTally pick(ContactTerms terms, const Loop& loop) {
  const int key = terms.sliding + 2 * terms.rolling + 4 * terms.torsion;
  switch (key) {
    case 0:
      return loop.template operator()<ContactTerms{false, false, false}>();
    case 1:
      return loop.template operator()<ContactTerms{true, false, false}>();
    case 2:
      return loop.template operator()<ContactTerms{false, true, false}>();
    case 3:
      return loop.template operator()<ContactTerms{true, true, false}>();
    case 4:
      return loop.template operator()<ContactTerms{false, false, true}>();
    case 5:
      return loop.template operator()<ContactTerms{true, false, true}>();
    case 6:
      return loop.template operator()<ContactTerms{false, true, true}>();
    default:
      return loop.template operator()<ContactTerms{true, true, true}>();
  }
}

ContactTally pick_pairs(const PairTask& task, ContactTerms terms) {
  return pick(terms, [&]<ContactTerms t>() {
    return task.radius > 0 ? collide_pairs<t, true>(task) : collide_pairs<t, false>(task);
  });
}

ContactTally pick_planes(const PlaneTask& task, ContactTerms terms) {
  return pick(terms, [&]<ContactTerms t>() { return collide_planes<t>(task); });
}

constexpr Kernels make_kernels(const char* name) {
  return {name, lanes, pick_pairs, pick_planes, sample_nearest, advance};
}

}  // namespace
}  // namespace clog
