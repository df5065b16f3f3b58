// Are the bursts of a run that clears its clogs alike, from the first to the last, and independent of each other?
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "postprocess/events/run_groups.hpp"
#include "postprocess/laws/confidence.hpp"
#include "postprocess/laws/sequences.hpp"
#include "postprocess/summary/quantities.hpp"

namespace clogflow::postprocess {

struct Fifth {
  std::size_t bursts = 0;
  Estimate mean;  ///< passages per burst, those of none included; interval over seeds
};

/// Whole bursts by their number within the seed. Those of zero passages belong to them.
struct BurstOrder {
  std::size_t bursts = 0;
  std::array<Fifth, 5> fifths;  ///< burst k of n lies in fifth 5 k / n
  PermutationTest trend;        ///< of size and number
  PermutationTest memory;       ///< of successive sizes
  Estimate memory_interval;     ///< of the latter, over seeds
  bool depends = false;         ///< trend or memory is real: p < 0.05
  std::string words;
};

/// Absent where the protocol leaves clogs alone, or for fewer than `fewest_ordered_bursts`.
std::optional<BurstOrder> burst_order(const RunGroup& group, const Resampling& resampling);

inline constexpr std::size_t fewest_ordered_bursts = 20;

/// Mean bursts whose bursts depend on each other: the wider interval of resampled seeds and of resampled blocks of
/// successive bursts, sqrt(n) of the n of a seed; never that of the counts, which takes bursts for independent.
/// \source Künsch 1989, Ann. Stat. 17:1217 (blocks)
Estimate dependent_estimate(const Quantity& quantity, const RunGroup& group, const Resampling& resampling);

}  // namespace clogflow::postprocess
