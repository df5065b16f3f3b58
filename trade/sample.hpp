// What the runs of one setting measured, cut into pieces that can be resampled.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "postprocess/summary/quantities.hpp"

namespace clogflow::trade {

/// A fifth of a run. Pieces of one run are taken as independent: a burst lasts a hundredth of it, though
/// packs remember for longer, so that intervals from a single seed are rather too narrow.
struct Piece {
  std::uint64_t seed = 0;
  int number = 0;  ///< within its run, from 0
  postprocess::Totals totals;
  double samples = 0;           ///< rows of the series in it
  double packing_fraction = 0;  ///< sum over them [-]
  double coordination = 0;      ///< sum of 2 contacts over particles [-]
  double largest_overlap = 0;   ///< sum, in diameters [-]
};

struct Sample {
  std::vector<Piece> pieces;
  int runs = 0;
  double simulated = 0;  ///< filling included [s]
  double particle_steps = 0;
  double wall_seconds = 0;
  double step_over_limit = 0;  ///< largest step over the smallest limit that the contacts of its run had [-]
};

/// Reads the run files of a folder. Empty if it has none. \throws Error on a damaged file
Sample read_sample(const std::filesystem::path& folder);

/// One number of a sample: a quantity of stats.json over its pieces, or a mean over the rows of the series in them.
struct Observable {
  std::string key;
  std::string meaning;
  bool is_share;                                    ///< differences are absolute, not relative
  const postprocess::Quantity* quantity = nullptr;  ///< nullptr: the mean
  double Piece::*rows = nullptr;                    ///< sum over the rows

  /// NaN where it is undefined
  double value(const std::vector<const Piece*>& pieces) const;
};

/// Everything that the study compares.
const std::vector<Observable>& observables();

/// A sample compared with a reference, both whole. The bootstrap draws a piece of one together with its
/// counterpart in the other (same seed, same part of the run), where there is one.
struct Difference {
  double reference = 0, value = 0;
  double low = 0, high = 0;  ///< of the difference, 95 % over all observables together; NaN where it cannot be given
  double difference = 0;     ///< relative, or absolute for a share; NaN where it is undefined
  /// Whether the interval excludes zero.
  bool real() const { return low > 0 || high < 0; }
};

Difference compare(const Observable& observable, const Sample& reference, const Sample& sample);

}  // namespace clogflow::trade
