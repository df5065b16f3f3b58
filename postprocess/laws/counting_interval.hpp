// Exact intervals from counts: how well so few events can be known, and what none says.
#pragma once

#include <cstddef>

#include "postprocess/laws/confidence.hpp"

namespace clogflow::postprocess {

/// Mean size of a burst that stops after each passage with the same probability p: 1/p.
///   value = passages / stops; interval from that of p (Clopper & Pearson)
/// Bursts that were cut off enter with their passages alone. No stop: value and high are NaN, low is
/// the one-sided bound 1/(1 - (1 - level)^(1/passages)), about passages/3 at 95 %.
/// \param stops bursts that a clog ended, <= passages \param passages all passages
/// \return NaN throughout without a passage
/// \source Clopper & Pearson 1934, Biometrika 26:404
Estimate mean_burst_from_counts(std::size_t stops, std::size_t passages, double level);

/// Rate of events in an exposure (Poisson): value = events / exposure, interval exact.
/// No event: value and low are 0, high is the one-sided bound -ln(1 - level)/exposure.
/// \param exposure > 0 [1/unit of the rate] \return NaN throughout without exposure
/// \source Garwood 1936, Biometrika 28:437
Estimate rate_from_counts(std::size_t events, double exposure, double level);

/// Share of a whole (binomial): value = part / whole, interval exact (Clopper & Pearson). None or all:
/// the one-sided bound.
/// \param part <= whole \return NaN throughout for whole = 0
Estimate share_from_counts(std::size_t part, std::size_t whole, double level);

/// The wider of two intervals on each side; NaN sides give way. The value is the first one's.
Estimate wider(const Estimate& a, const Estimate& b);

}  // namespace clogflow::postprocess
