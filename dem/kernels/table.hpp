// The table of one instruction set. Included once per instruction set.
#pragma once

#include "dem/kernels/advance.hpp"
#include "dem/kernels/pairs.hpp"
#include "dem/kernels/planes.hpp"

namespace clog {
namespace {

ContactTally pick_pairs(const PairTask& task, ContactTerms terms) {
  const int key = terms.sliding + 2 * terms.rolling + 4 * terms.torsion;
  switch (key) {
    case 0: return collide_pairs<ContactTerms{false, false, false}>(task);
    case 1: return collide_pairs<ContactTerms{true, false, false}>(task);
    case 2: return collide_pairs<ContactTerms{false, true, false}>(task);
    case 3: return collide_pairs<ContactTerms{true, true, false}>(task);
    case 4: return collide_pairs<ContactTerms{false, false, true}>(task);
    case 5: return collide_pairs<ContactTerms{true, false, true}>(task);
    case 6: return collide_pairs<ContactTerms{false, true, true}>(task);
    default: return collide_pairs<ContactTerms{true, true, true}>(task);
  }
}

ContactTally pick_planes(const PlaneTask& task, ContactTerms terms) {
  const int key = terms.sliding + 2 * terms.rolling + 4 * terms.torsion;
  switch (key) {
    case 0: return collide_planes<ContactTerms{false, false, false}>(task);
    case 1: return collide_planes<ContactTerms{true, false, false}>(task);
    case 2: return collide_planes<ContactTerms{false, true, false}>(task);
    case 3: return collide_planes<ContactTerms{true, true, false}>(task);
    case 4: return collide_planes<ContactTerms{false, false, true}>(task);
    case 5: return collide_planes<ContactTerms{true, false, true}>(task);
    case 6: return collide_planes<ContactTerms{false, true, true}>(task);
    default: return collide_planes<ContactTerms{true, true, true}>(task);
  }
}

constexpr Kernels make_kernels(const char* name) {
  return {name, lanes, pack, unpack, pick_pairs, lubricate_far, pick_planes, advance};
}

}  // namespace
}  // namespace clog
