// The numbers of an ensemble: ratios of totals, with intervals, and what is said where there is
// none.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "postprocess/laws/confidence.hpp"
#include "postprocess/summary/totals.hpp"

namespace clogflow::postprocess {

enum class ShownBy {
  any_part,    ///< of a run: it can be compared between the halves
  end_of_run,  ///< alone
};

/// One number of an ensemble: a ratio of totals, NaN where they do not define it.
struct Quantity {
  std::string key;
  std::string unit;
  std::string meaning;
  std::string missing;  ///< what there is none of where it is undefined
  double (*value)(const Totals&);
  /// What the counts alone say, as if events were independent; nullptr where nothing is counted.
  /// For an undefined value its bound, on one side.
  Estimate (*counted)(const Totals&, double level);
  ShownBy shown_by = ShownBy::any_part;
};

/// Everything that stats.json gives with an interval, in this order.
const std::vector<Quantity>& quantities();

/// The one with this key, or nullptr.
const Quantity* find_quantity(const std::string& key);

/// Sums over the parts of an ensemble (seeds, or blocks of bursts) and over resampled ones: drawn once, for all
/// quantities.
struct ResampledSums {
  ResampledSums(const std::vector<Totals>& parts, const Resampling& resampling);

  Totals whole;
  std::vector<Totals> replicates;  ///< none of fewer than 2 parts
  Resampling resampling;
};

/// Value of a quantity over the parts with its interval from resampled parts.
Estimate resampled(const Quantity& quantity, const ResampledSums& sums);

/// Value of a quantity over an ensemble with its interval from resampled seeds. Where these all
/// give the same, which is no certainty, the interval is the exact one of the counts, if they have
/// one. The note says so, and why there is no value or no interval.
Estimate estimate(const Quantity& quantity, const ResampledSums& seeds);

/// Second half minus first half, seeds resampled in pairs: a quantity whose interval excludes 0
/// drifts. \param first, second  of equally many seeds, resampled alike
Estimate estimate_change(const Quantity& quantity, const ResampledSums& first, const ResampledSums& second);

}  // namespace clogflow::postprocess
