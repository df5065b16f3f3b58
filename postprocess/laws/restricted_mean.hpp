// Mean of counts of which some were cut: the area under their survival function.
#pragma once

#include <cstddef>
#include <vector>

#include "postprocess/laws/confidence.hpp"
#include "postprocess/laws/trial_count.hpp"

namespace clogflow::postprocess {

/// E[min(s, up_to)] = sum_{n < up_to} S(n), S(n) = P(s > n) of Kaplan & Meier. Beyond the last count of a sample, if
/// that was cut, S stays as it is. \source Irwin 1949, J. Hygiene 47:188 (restricted mean); Gill 1980 (beyond the last
/// count)
double restricted_mean(const std::vector<TrialCount>& sample, std::size_t up_to);

struct MeanCount {
  Estimate mean;              ///< interval from resampled counts
  std::size_t up_to = 0;      ///< largest count: as far as S is known
  bool is_restricted = true;  ///< S does not end at 0 there: the whole mean is larger
};

/// Without a cut count this is the plain mean. Without an event only a bound is known, that of a law without memory.
/// Where resampled counts all agree the interval is the exact one of that law; the note says so.
MeanCount mean_count(const std::vector<TrialCount>& sample, const Resampling& resampling);

}  // namespace clogflow::postprocess
