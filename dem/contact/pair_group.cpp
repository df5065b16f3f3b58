#include "dem/contact/pair_group.hpp"

#include <algorithm>
#include <tuple>

namespace clogflow {

void put_in_rounds(std::vector<PairGroup>& groups, int blocks) {
  std::ranges::sort(groups, {}, [](const PairGroup& g) { return std::pair(g.block, g.other); });
  std::vector<std::vector<std::uint8_t>> taken(blocks);  // of each block and round
  const auto is_taken = [&](int block, int round) {
    return round < static_cast<int>(taken[block].size()) && taken[block][round];
  };
  for (PairGroup& group : groups) {
    group.round = group.block == group.other ? 0 : 1;
    while (is_taken(group.block, group.round) || is_taken(group.other, group.round)) ++group.round;
    for (const int block : {group.block, group.other}) {
      if (static_cast<int>(taken[block].size()) <= group.round) taken[block].resize(group.round + 1, 0);
      taken[block][group.round] = 1;
    }
  }
  std::ranges::stable_sort(groups, {}, &PairGroup::round);
}

}  // namespace clogflow
