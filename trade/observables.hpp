// The numbers that settings are compared in: those that users publish.
#pragma once

#include <string>
#include <vector>

#include "postprocess/summary/quantities.hpp"
#include "trade/sample.hpp"

namespace clogflow::trade {

using Pieces = std::vector<const Piece*>;

/// One number of a sample. NaN where the pieces do not define it.
struct Observable {
  std::string key;
  std::string meaning;
  bool is_share;  ///< differences are absolute, not relative
  /// A protocol that clears clogs cuts the arrests: what is left of them says more about it than about the clogs.
  bool needs_whole_arrests;
  /// The power of the overlap that it answers to: a jammed pack gains contacts with the root of its compression.
  /// \source O'Hern et al. 2003, Phys. Rev. E 68:011306
  double overlap_power;
  double (*value)(const Observable&, const Pieces&, double usual_burst);
  const postprocess::Quantity* quantity = nullptr;  ///< of the totals
  RowMean Piece::*rows = nullptr;                   ///< mean over rows of the series
};

/// Everything that the study compares.
const std::vector<Observable>& observables();

/// Median size of the bursts that a clog ended: what "early" is measured against. 0 without any.
double usual_burst(const Sample& sample);

/// A sample compared with another, both whole.
struct Difference {
  double reference = 0, value = 0;
  double difference = 0;     ///< relative, or absolute for a share; NaN where it is undefined
  double low = 0, high = 0;  ///< of the difference, 95 %; NaN where it cannot be given

  /// Whether the interval excludes zero.
  bool real() const { return low > 0 || high < 0; }

  /// The largest difference that the interval allows: the two are equal within x if this is at most x. Two one-sided
  /// tests at 2.5 %. \source Schuirmann 1987, J. Pharmacokinet. Biopharm. 15:657 [-]
  double within() const;
};

/// The bootstrap draws a piece of one together with its counterpart in the other (same seed, same part of the run),
/// where there is one.
Difference compare(const Observable& observable, const Sample& reference, const Sample& sample);

/// Value of a sample and the standard error of its logarithm (of itself for a share), from resampled pieces.
struct Spread {
  double value = 0, error = 0;
};

Spread spread_of(const Observable& observable, const Sample& sample, double usual_burst);

}  // namespace clogflow::trade
