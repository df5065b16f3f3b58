// What the runs of one setting measured, cut into pieces that can be resampled.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "postprocess/summary/totals.hpp"

namespace clogflow::trade {

/// Sum and number of rows of the series.
struct RowMean {
  double sum = 0, rows = 0;
};

/// A fifth of a run. Pieces of one run are taken as independent: a burst lasts a hundredth of it, though
/// packs remember for longer, so that intervals from a single seed are rather too narrow.
struct Piece {
  std::uint64_t seed = 0;
  int number = 0;  ///< within its run, from 0
  postprocess::Totals totals;
  std::vector<double> sizes;      ///< of the bursts that a clog ended, zeros included [-]
  RowMean packing_while_flowing;  ///< of the strip next to the narrowing, while particles pass [-]
  RowMean contacts_at_rest;       ///< contacts of a particle with others, two Stokes times into an arrest or later [-]
};

struct Sample {
  std::vector<Piece> pieces;
  int runs = 0;
  double simulated = 0;  ///< filling included [s]
  double particle_steps = 0;
  double processor_seconds = 0;
  double largest_step = 0;  ///< over the smallest limit that the contacts of its run had, in any run [-]
  double mean_step = 0;     ///< the same, mean over the runs [-]

  double clogs() const;  ///< bursts that a clog ended, empty ones included
};

/// Reads the run files of a folder. Empty if it has none. \throws Error on a damaged file
Sample read_sample(const std::filesystem::path& folder);

}  // namespace clogflow::trade
