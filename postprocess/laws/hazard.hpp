// The chance that the next trial is the event, and whether it changes with the trials so far.
#pragma once

#include <cstddef>
#include <vector>

#include "postprocess/laws/confidence.hpp"
#include "postprocess/laws/trial_count.hpp"

namespace clogflow::postprocess {

/// Maximum-likelihood hazard per trial of a law without memory, and its exact interval.
///   h = events / (events + passed)
/// Without an event: value 0, high the one-sided bound 1 - (1 - level)^(1/passed), about 3/passed at 95 % (rule of
/// three). NaN throughout where no trial was seen.
/// \source Clopper & Pearson 1934, Biometrika 26:404; Hanley & Lippman-Hand 1983, J. Am. Med. Assoc. 249:1743
Estimate hazard_per_trial(const std::vector<TrialCount>& sample, double level);

/// The mean number of trials before the event that a hazard means, 1/h - 1; the ends of the interval change places.
Estimate mean_of_hazard(const Estimate& hazard);

/// Trials from ... to - 1.
struct HazardBin {
  std::size_t from = 0, to = 0;
  std::size_t events = 0;
  std::size_t trials = 0;  ///< seen, those of the events included
  Estimate hazard;         ///< events / trials, exact interval
};

/// The hazard against the trials so far. A bin ends as soon as it holds `fewest` events; a rest with fewer belongs to
/// the last one, so that all events count. Fewer events in all: a single bin. Empty where no trial was seen.
std::vector<HazardBin> hazard_bins(const std::vector<TrialCount>& sample, std::size_t fewest, double level);

/// Events in a bin: known to a third.
inline constexpr std::size_t events_per_hazard_bin = 10;

}  // namespace clogflow::postprocess
