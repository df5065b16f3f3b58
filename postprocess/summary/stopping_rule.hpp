// How many seeds are enough: a bound on one number of the ensemble.
#pragma once

#include <string>
#include <vector>

#include "postprocess/summary/quantities.hpp"

namespace clogflow::postprocess {

/// "bursts>=1000" (also arrests, passages, releases), or "relative_error(mean_burst)<=0.05" with any
/// quantity of stats.json: half the width of its 95 % interval over its value.
///
/// Used on the first seeds 1..n of a list for growing n, the rule takes the smallest n that meets it, whatever
/// ran in which order. Neglects that looking many times stops a little early: an interval that happens to be
/// narrow is more likely to be taken. A relative error is not asked of fewer than `fewest_seeds` seeds, and that
/// of a mean burst, or of the hazard of the first one, is never less than the exact one of its counts.
class StoppingRule {
public:
  static constexpr std::size_t fewest_seeds = 5;

  /// \throws Error on an unknown number, a bound that is none, or the wrong direction
  explicit StoppingRule(std::string text);

  /// The number that the rule bounds; NaN where these seeds do not define it.
  double value(const std::vector<Totals>& seeds) const;

  bool met(const std::vector<Totals>& seeds) const;

  const std::string& text() const { return text_; }
  const std::string& statistic() const { return statistic_; }

private:
  std::string text_, statistic_;
  double Totals::*count_ = nullptr;
  const Quantity* quantity_ = nullptr;  // of a relative error
  double bound_ = 0;
};

}  // namespace clogflow::postprocess
