// Pairs that one thread goes through at a time.
#pragma once

#include <vector>

#include "dem/contact/contact_set.hpp"

namespace clogflow {

/// The listed pairs i < j of the particles of one block, or of two, and which of them touch.
struct PairGroup {
  int block = 0, other = 0;  ///< of i and of j
  int round = 0;             ///< groups of the same round share no block
  std::vector<int> first, second;
  ContactSet contacts;

  PairGroup() = default;
  PairGroup(int one, int two) : block(one), other(two) {}

  Candidates candidates() const { return {first.data(), second.data(), first.size()}; }

  template <class Archive>
  void exchange(Archive& archive) {
    archive(block, other, round, first, second, contacts);
  }
};

/// Puts groups into rounds, and in the order of these: pairs inside a block first, then those between blocks, as early
/// as no group of the same round has one of their blocks. A particle's loads are summed in this order, with any number
/// of threads.
void put_in_rounds(std::vector<PairGroup>& groups, int blocks);

}  // namespace clogflow
